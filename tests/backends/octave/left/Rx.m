function X = Rx(angle)
% RX  Coordinates from the original frame to the moved one, which is turned by angle (rad) about x.
  c = cos(angle);
  s = sin(angle);
  X = [1, 0, 0, 0; 0, c, s, 0; 0, -s, c, 0; 0, 0, 0, 1];
end
