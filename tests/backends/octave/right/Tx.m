function X = Tx(length)
% TX  Coordinates from the moved frame to the original one, which is length (m) away along x.
  X = eye(4);
  X(1, 4) = length;
end
