function X = Ty(length)
% TY  Coordinates from the original frame to the moved one, which is length (m) away along y.
  X = eye(4);
  X(2, 4) = -length;
end
