function X = Tx(length)
% TX  Coordinates from the original frame to the moved one, which is length (m) away along x.
  X = eye(4);
  X(1, 4) = -length;
end
