function messages()
% MESSAGES  Calls generated functions with wrong arguments, and asks for help; each answer must be the expected one.

  limbs(quadruped.model());

  z = zeros(3, 1);
  w = zeros(12, 1);
  v = zeros(6, 1);

  % missing
  expect(@() hyl.forward_dynamics(), 'hyl.forward_dynamics: missing q, qd, tau');
  expect(@() hyl.forward_dynamics(z), 'hyl.forward_dynamics: missing qd, tau');
  expect(@() hyl_parametric.gravity_forces(), 'hyl_parametric.gravity_forces: missing parameters, q');
  expect(@() hyl.forward_dynamics(z, z, z), '');

  % a quaternion of another length; NaN is not refused, nor are numbers with four digits
  q = [1; 0; 0; 0; 0; 1; 0; 0; 0];
  expect(@() ball_leg.gravity_forces(q), '');
  expect(@() ball_leg.gravity_forces([0.7071; 0.7071; 0; 0; q(5:9)]), '');
  expect(@() ball_leg.gravity_forces([NaN; q(2:9)]), '');
  expect(@() ball_leg.gravity_forces(1.01 * q), ...
    'ball_leg.gravity_forces: q(1:4) must be a unit quaternion w, x, y, z, has norm 1.01');
  expect(@() ball_leg.gravity_forces([q(1:5); zeros(4, 1)]), ...
    'ball_leg.gravity_forces: q(6:9) must be a unit quaternion w, x, y, z, has norm 0');

  % another shape
  expect(@() hyl.inverse_dynamics([1, 2, 3], z, z), 'hyl.inverse_dynamics: q must be 3 x 1, is 1 x 3');
  expect(@() hyl.inverse_dynamics(z, z, w), 'hyl.inverse_dynamics: qdd must be 3 x 1, is 12 x 1');
  expect(@() hyl.inverse_dynamics(z, z, []), 'hyl.inverse_dynamics: qdd must be 3 x 1, is 0 x 0');
  expect(@() hyl.joint_space_inertia(zeros(3, 3)), 'hyl.joint_space_inertia: q must be 3 x 1, is 3 x 3');
  expect(@() hyl.inverse_dynamics(z, z, z, [], zeros(6, 3)), ...
    'hyl.inverse_dynamics: external must be 6 x 4, is 6 x 3');
  expect(@() hyl.inverse_dynamics(z, z, z, [], zeros(4, 6)), ...
    'hyl.inverse_dynamics: external must be 6 x 4, is 4 x 6');
  expect(@() hyl.gravity_forces(z, -9.81), ...
    'hyl.gravity_forces: gravity must be 3 x 1 (m/s^2, in base coordinates), is 1 x 1');
  expect(@() hyl.inertia_factor.inverse_L(eye(2), z), 'hyl.inertia_factor.inverse_L: L must be 3 x 3, is 2 x 2');
  expect(@() hyl.transforms.homogeneous.fr_base_X_fr_foot(0.5), ...
    'hyl.transforms.homogeneous.fr_base_X_fr_foot: q must be 3 x 1, is 1 x 1');
  expect(@() hyl_parametric.gravity_forces(z, z), ...
    'hyl_parametric.gravity_forces: parameters must be a struct, as parameters() returns it');
  expect(@() hyl_parametric.gravity_forces(hyl_parametric.parameters(), z), '');

  % a floating base: gravity has no default
  without = 'missing gravity (m/s^2, in base coordinates)';
  expect(@() quadruped.forward_dynamics(w, w, w, v), ['quadruped.forward_dynamics: ' without]);
  expect(@() quadruped.inverse_dynamics(w, w, w, v), ['quadruped.inverse_dynamics: ' without]);
  expect(@() quadruped.inverse_dynamics_fully_actuated(w, w, w, v, v), ...
    ['quadruped.inverse_dynamics_fully_actuated: ' without]);
  expect(@() quadruped.bias_forces(w, w, v), ['quadruped.bias_forces: ' without]);
  expect(@() quadruped.gravity_forces(w), ['quadruped.gravity_forces: ' without]);
  expect(@() quadruped.potential_energy(w), ['quadruped.potential_energy: ' without]);
  expect(@() quadruped.gravity_forces(w, []), ...
    'quadruped.gravity_forces: gravity must be 3 x 1 (m/s^2, in base coordinates), is 0 x 0');
  expect(@() quadruped.forward_dynamics(w, w, w, v, [0; 0; -9.81]), '');

  % help; of a package Octave shows that of its file Contents.m
  shows('hyl.Contents', 'Functions of robot HyL');
  shows('hyl.Contents', 'hyl.forward_dynamics - Joint accelerations');
  shows('hyl.forward_dynamics', 'tau (3 x 1)  joint forces');
  shows('hyl.transforms.homogeneous.fr_base_X_fr_foot', 'q (3 x 1)');

  check_files('hyl');
  check_files('names');
  disp('all messages are as expected');
end

% The message of the call; empty where it goes well.
function expect(call, message)
  found = '';
  try
    call();
  catch fault
    found = fault.message;
  end
  if ~strcmp(found, message)
    error('"%s" is not "%s"', found, message);
  end
end

function shows(name, text)
  help_text = help(name);
  if isempty(strfind(help_text, text))
    error('help %s does not show "%s": %s', name, text, help_text);
  end
end

% No file or package has the name of a function of Octave.
function check_files(package)
  functions = [__builtins__(); __list_functions__()];
  folder = fileparts(which([package '.model']));
  pending = {folder};
  count = 0;
  while ~isempty(pending)
    entries = dir(pending{end});
    parent = pending{end};
    pending(end) = [];
    for k = 1:numel(entries)
      [~, name, extension] = fileparts(entries(k).name);
      if entries(k).isdir && name(1:min(1, end)) == '+'
        pending{end + 1} = fullfile(parent, entries(k).name);
        name = name(2:end);
      elseif ~strcmp(extension, '.m')
        continue
      end
      count = count + 1;
      if any(strcmp(name, functions))
        error('%s has the name of a function of Octave', fullfile(parent, entries(k).name));
      end
    end
  end
  if count < 20
    error('%d files in %s', count, folder);
  end
end
