% Primitive transforms of the user, with the position of the moved frame on the right: coordinates from the moved frame to
% the original one. In MATLAB each is a file of its own.
1;

function X = Rx(angle)
% RX  Coordinates from the moved frame to the original one, which is turned by angle (rad) about x.
  c = cos(angle);
  s = sin(angle);
  X = [1, 0, 0, 0; 0, c, -s, 0; 0, s, c, 0; 0, 0, 0, 1];
end

function X = Ry(angle)
% RY  Coordinates from the moved frame to the original one, which is turned by angle (rad) about y.
  c = cos(angle);
  s = sin(angle);
  X = [c, 0, s, 0; 0, 1, 0, 0; -s, 0, c, 0; 0, 0, 0, 1];
end

function X = Rz(angle)
% RZ  Coordinates from the moved frame to the original one, which is turned by angle (rad) about z.
  c = cos(angle);
  s = sin(angle);
  X = [c, -s, 0, 0; s, c, 0, 0; 0, 0, 1, 0; 0, 0, 0, 1];
end

function X = Tx(length)
% TX  Coordinates from the moved frame to the original one, which is length (m) away along x.
  X = eye(4);
  X(1, 4) = length;
end

function X = Ty(length)
% TY  Coordinates from the moved frame to the original one, which is length (m) away along y.
  X = eye(4);
  X(2, 4) = length;
end

function X = Tz(length)
% TZ  Coordinates from the moved frame to the original one, which is length (m) away along z.
  X = eye(4);
  X(3, 4) = length;
end
