function X = Ry(angle)
% RY  Coordinates from the original frame to the moved one, which is turned by angle (rad) about y.
  c = cos(angle);
  s = sin(angle);
  X = [c, 0, -s, 0; 0, 1, 0, 0; s, 0, c, 0; 0, 0, 0, 1];
end
