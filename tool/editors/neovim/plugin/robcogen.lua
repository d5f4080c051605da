-- Documents of robcogen: their file types, and the language server for them. Neovim 0.7 or newer.
local group = vim.api.nvim_create_augroup('robcogen', { clear = true })

for _, name in ipairs({ 'kindsl', 'dtdsl', 'motdsl', 'ctdsl' }) do
  vim.api.nvim_create_autocmd({ 'BufRead', 'BufNewFile' }, {
    group = group,
    pattern = '*.' .. name,
    callback = function()
      vim.bo.filetype = name
      vim.bo.commentstring = '// %s'
      require('robcogen').start(name)
    end,
  })
end

-- A URDF keeps the file type of XML.
vim.api.nvim_create_autocmd({ 'BufRead', 'BufNewFile' }, {
  group = group,
  pattern = '*.urdf',
  callback = function()
    if vim.bo.filetype == '' then
      vim.bo.filetype = 'xml'
    end
    require('robcogen').start('urdf')
  end,
})
