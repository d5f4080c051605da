function X = Ry(angle)
% RY  Coordinates from the moved frame to the original one, which is turned by angle (rad) about y.
  c = cos(angle);
  s = sin(angle);
  X = [c, 0, s, 0; 0, 1, 0, 0; -s, 0, c, 0; 0, 0, 0, 1];
end
