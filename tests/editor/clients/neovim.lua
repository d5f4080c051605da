-- A session of Neovim with the language server: diagnostics, hover, rename and formatting.
-- Environment: ROBCOGEN (the program), FOLDER (documents), PLUGIN (tool/editors/neovim), RESULT (a file for the outcome).
local checks = {}
local function check(name, holds, shown)
  table.insert(checks, (holds and 'ok ' or 'FAILED ') .. name .. (holds and '' or ': ' .. vim.inspect(shown)))
end
local function finish()
  vim.fn.writefile(checks, vim.env.RESULT)
  vim.cmd('qall!')
end
local function text_of(buffer)
  return table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), '\n')
end

local function run()
  vim.opt.runtimepath:prepend(vim.env.PLUGIN)
  vim.o.hidden = true
  vim.cmd('runtime plugin/robcogen.lua')
  require('robcogen').setup({
    command = { vim.env.ROBCOGEN, 'language-server' },
    settings = { importFolders = { vim.env.FOLDER .. '/parts' } },
  })

  vim.cmd('edit ' .. vim.env.FOLDER .. '/arm.kindsl')
  local robot = vim.api.nvim_get_current_buf()
  check('file type', vim.bo.filetype == 'kindsl', vim.bo.filetype)
  local found = vim.wait(10000, function()
    return #vim.diagnostic.get(robot) == 1
  end, 20)
  local d = vim.diagnostic.get(robot)[1] or {}
  check('diagnostic', found and d.code == 'unknown-link' and d.lnum == 2 and d.col == 43 and d.end_col == 48, vim.diagnostic.get(robot))

  -- The misspelt name is repaired by hand: the message goes.
  vim.api.nvim_buf_set_text(robot, 2, 43, 2, 48, { 'upper' })
  check('diagnostic is gone', vim.wait(10000, function()
    return #vim.diagnostic.get(robot) == 0
  end, 20), vim.diagnostic.get(robot))

  local function ask(method, line, character, more)
    local parameters = vim.tbl_extend('force', {
      textDocument = { uri = vim.uri_from_bufnr(robot) },
      position = { line = line, character = character },
    }, more or {})
    local answers = vim.lsp.buf_request_sync(robot, method, parameters, 10000) or {}
    local _, answer = next(answers)
    return (answer or {}).result
  end

  local hover = ask('textDocument/hover', 3, 11)
  check('hover', hover and hover.contents.value:find('mass 2 kg', 1, true) ~= nil, hover)

  local edit = ask('textDocument/rename', 3, 11, { newName = 'arm' })
  check('rename answers', edit ~= nil and edit.changes ~= nil, edit)
  if edit then
    local client = vim.lsp.get_client_by_id(next(vim.lsp.buf_get_clients(robot)))
    vim.lsp.util.apply_workspace_edit(edit, (client or {}).offset_encoding or 'utf-16')
    local text = text_of(robot)
    check('rename in the robot', text:find('arm via shoulder', 1, true) and not text:find('upper', 1, true), text)
    local list = vim.fn.bufadd(vim.env.FOLDER .. '/arm.dtdsl')
    vim.fn.bufload(list)
    check('rename in the list', text_of(list):find('fr_arm', 1, true) ~= nil, text_of(list))
  end

  local edits = ask('textDocument/formatting', 0, 0, { options = { tabSize = 4, insertSpaces = true } })
  check('formatting answers', edits ~= nil, edits)
  if edits then
    vim.lsp.util.apply_text_edits(edits, robot, 'utf-16')
    check('formatting', text_of(robot):find('\n    link arm {\n        id = 1\n', 1, true) ~= nil, text_of(robot))
    check('comment is kept', text_of(robot):find('// \u{1F916} the arm', 1, true) ~= nil, text_of(robot))
  end
  vim.wait(200, function() return false end)
  check('still no diagnostics', #vim.diagnostic.get(robot) == 0, vim.diagnostic.get(robot))

  vim.cmd('edit ' .. vim.env.FOLDER .. '/biped.kindsl')
  robot = vim.api.nvim_get_current_buf()
  local part = ask('textDocument/definition', 1, 44)
  check('imports from folders of the settings', vim.inspect(part):find('parts/leg.kindsl', 1, true) ~= nil, part)
end

local sound, fault = pcall(run)
check('no fault', sound, fault)
finish()
