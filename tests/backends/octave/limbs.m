function limbs(model)
% LIMBS  The limbs of a model have the elements that begin with their names.

  assert(numel(model.limbs) == 4);
  for limb = model.limbs
    for kind = {'link', 'joint', 'frame'}
      list = [kind{1}, 's'];
      own = limb.([kind{1}, '_names']);
      names = model.(list)(limb.(list));
      assert(numel(own) > 0 && numel(own) == numel(names));
      for i = 1:numel(own)
        expected = regexprep([limb.name, '_', own{i}], ['^', limb.name, '_fr_'], ['fr_', limb.name, '_']);
        assert(strcmp(names{i}, expected), '%s is not %s', names{i}, expected);
      end
    end
    assert(limb.first_link == limb.links(1));
  end
end
