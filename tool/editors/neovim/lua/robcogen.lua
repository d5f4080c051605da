-- Starts `robcogen language-server` for a buffer. Buffers of one folder share a server.
local M = { command = { 'robcogen', 'language-server' }, settings = {} }
local clients = {}

-- `opts.command`: the program and its arguments, if it is not on the path. `opts.settings`: importFolders, a list.
function M.setup(opts)
  M.command = (opts or {}).command or M.command
  M.settings = (opts or {}).settings or M.settings
end

local function root_of(file)
  local folder = vim.fn.fnamemodify(file, ':p:h')
  local git = vim.fn.finddir('.git', folder .. ';')
  return git ~= '' and vim.fn.fnamemodify(git, ':p:h:h') or folder
end

function M.start(language)
  local buffer = vim.api.nvim_get_current_buf()
  local root = root_of(vim.api.nvim_buf_get_name(buffer))
  local config = {
    name = 'robcogen',
    cmd = M.command,
    root_dir = root,
    -- Neovim 0.7 does not answer requests for settings.
    init_options = M.settings,
    settings = { robcogen = M.settings },
    workspace_folders = { { uri = vim.uri_from_fname(root), name = root } },
    get_language_id = function()
      return language
    end,
  }
  if vim.lsp.start then
    vim.lsp.start(config)
    return
  end
  -- Neovim 0.7
  local known = clients[root]
  if not known or not vim.lsp.get_client_by_id(known) then
    clients[root] = vim.lsp.start_client(config)
  end
  if clients[root] then
    vim.lsp.buf_attach_client(buffer, clients[root])
  end
end

return M
