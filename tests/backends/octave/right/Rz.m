function X = Rz(angle)
% RZ  Coordinates from the moved frame to the original one, which is turned by angle (rad) about z.
  c = cos(angle);
  s = sin(angle);
  X = [c, -s, 0, 0; s, c, 0, 0; 0, 0, 1, 0; 0, 0, 0, 1];
end
