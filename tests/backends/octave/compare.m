function compare(folder, states)
% COMPARE  Calls generated functions and compares with values that were computed elsewhere.
%   folder holds calls.txt and values.bin, as calls.h describes; the packages are on the path.
%   states: how many states of each call values.bin holds.
%   Prints the worst relative error of each call and a count of all; it is an error when one differs.

  % Both sides do the same operations in the same order; what differs is how the sines and cosines of
  % their arguments are rounded (one unit in the last place), and solving for accelerations amplifies that.
  tolerance = 1e-12;

  calls = strsplit(strtrim(fileread(fullfile(folder, 'calls.txt'))), sprintf('\n'));
  file = fopen(fullfile(folder, 'values.bin'));
  failures = 0;
  compared = 0;
  functions = {};
  for k = 1:numel(calls)
    call = parse(calls{k});
    values = fread(file, [sizes(call.arguments) + sizes(call.results), states], 'double');
    if size(values, 2) ~= states
      error('values.bin ends early');
    end
    typical = typical_sizes(values(sizes(call.arguments) + 1:end, :), call.results);
    worst = 0;
    for s = 1:states
      [arguments, used] = unpack(values(:, s), call.arguments, 0);
      expected = unpack(values(:, s), call.results, used);
      results = cell(1, numel(expected));
      [results{:}] = feval(call.name, arguments{:});
      for r = 1:numel(results)
        worst = max(worst, difference(results{r}, expected{r}, typical(r)));
      end
      compared = compared + 1;
    end
    remark = '';
    if ~(worst <= tolerance)
      failures = failures + 1;
      remark = '  DIFFERS';
    end
    fprintf('%-70s %8.1e%s\n', sprintf('%s/%d', call.name, numel(arguments)), worst, remark);
    functions{end + 1} = call.name;
  end
  if ~isempty(fread(file, 1))
    error('values.bin holds more than calls.txt says');
  end
  fclose(file);
  fprintf('%d functions, %d calls, %d states compared, %d differ\n', ...
    numel(unique(functions)), numel(calls), compared, failures);
  if failures > 0
    error('%d calls differ', failures);
  end
end

% Name, rows and columns of everything that a call takes and gives.
function call = parse(line)
  sides = strsplit(line, ' >');
  words = strsplit(sides{1}, ' ');
  call.name = words{1};
  call.arguments = arrays(words(2:end), 4);
  call.results = arrays(strsplit(strtrim(sides{2}), ' '), 3);
end

function list = arrays(words, width)
  list = struct('rows', {}, 'columns', {}, 'kind', {}, 'fields', {});
  for k = 1:width:numel(words)
    item.rows = str2double(words{k + 1});
    item.columns = str2double(words{k + 2});
    item.kind = 'array';
    item.fields = {};
    if width == 4
      parts = strsplit(words{k + 3}, ':');
      item.kind = parts{1};
      if numel(parts) > 1
        item.fields = strsplit(parts{2}, ',');
      end
    end
    list(end + 1) = item;
  end
end

function count = sizes(list)
  count = sum([list.rows] .* [list.columns]);
end

% The arrays that lie in a column of values behind the first ones.
function [arrays, first] = unpack(values, list, first)
  arrays = {};
  for k = 1:numel(list)
    count = list(k).rows * list(k).columns;
    array = reshape(values(first + 1:first + count), list(k).rows, list(k).columns);
    switch list(k).kind
      case 'array'
        arrays{end + 1} = array;
      case 'scalars'
        arrays = [arrays, num2cell(array)'];
      case 'struct'
        arrays{end + 1} = cell2struct(num2cell(array), list(k).fields, 1);
    end
    first = first + count;
  end
end

% The greatest element of each result, in the median state.
function typical = typical_sizes(values, list)
  typical = zeros(1, numel(list));
  first = 0;
  for k = 1:numel(list)
    count = list(k).rows * list(k).columns;
    if count > 0
      typical(k) = median(max(abs(values(first + 1:first + count, :)), [], 1));
    end
    first = first + count;
  end
end

% Greatest difference of an element, relative to the greatest element. A result that happens to be small, as a single
% element that passes zero, is a difference of terms: it is judged by the size of the others.
function worst = difference(result, expected, typical)
  if ~isequal(size(result), size(expected)) || ~all(isfinite(result(:)))
    worst = Inf;
    return
  end
  worst = max([0; abs(result(:) - expected(:))]) / max([realmin; typical; abs(expected(:))]);
end
