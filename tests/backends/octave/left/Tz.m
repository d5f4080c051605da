function X = Tz(length)
% TZ  Coordinates from the original frame to the moved one, which is length (m) away along z.
  X = eye(4);
  X(3, 4) = -length;
end
