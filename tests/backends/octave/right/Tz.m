function X = Tz(length)
% TZ  Coordinates from the moved frame to the original one, which is length (m) away along z.
  X = eye(4);
  X(3, 4) = length;
end
