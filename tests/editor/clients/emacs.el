;;; emacs.el --- A session of Emacs (Eglot) with the language server -*- lexical-binding: t -*-

;;; Commentary:
;; Diagnostics, hover, rename and formatting. Environment: as in neovim.lua, with PLUGIN tool/editors/emacs.

;;; Code:

(require 'cl-lib)
(add-to-list 'load-path (getenv "PLUGIN"))
(unless (require 'eglot nil t)
  (let ((default-directory "/usr/share/emacs/site-lisp/elpa/"))
    (normal-top-level-add-subdirs-to-load-path)))
(require 'robcogen-mode)
(require 'eglot)
(require 'flymake)

(defvar checks nil)
(defun check (name holds shown)
  "Remember whether the check NAME HOLDS; SHOWN says more."
  (push (if holds (format "ok %s" name) (format "FAILED %s: %S" name shown)) checks))

(defun wait-for (condition)
  "Wait until CONDITION holds, ten seconds at most."
  (let ((end (+ (float-time) 10)) result)
    (while (and (not (setq result (funcall condition))) (< (float-time) end))
      (accept-process-output nil 0.05))
    result))

(defun codes ()
  "Messages that Flymake shows."
  (mapcar #'flymake-diagnostic-text (flymake-diagnostics)))

(defun run ()
  "The session."
  (let ((default-directory (file-name-as-directory (getenv "FOLDER"))))
    (find-file (expand-file-name "arm.kindsl"))
    (check "mode" (eq major-mode 'kindsl-mode) major-mode)
    (setq-local eglot-sync-connect t)
    (setq-default eglot-workspace-configuration
                  `((:robcogen . (:importFolders [,(expand-file-name "parts")]))))
    (apply #'eglot (eglot--guess-contact))
    (setq flymake-no-changes-timeout 0.1)
    (flymake-mode 1)
    (wait-for #'flymake-diagnostics)
    (let ((d (car (flymake-diagnostics))))
      (check "diagnostic"
             (and d
                  (string-match-p "unknown-link" (flymake-diagnostic-text d))
                  (string= "uppor" (buffer-substring (flymake-diagnostic-beg d) (flymake-diagnostic-end d))))
             (codes)))
    (goto-char (point-min))
    (search-forward "uppor")
    (replace-match "upper")
    (eglot--signal-textDocument/didChange)
    (wait-for (lambda () (null (flymake-diagnostics))))
    (check "diagnostic is gone" (null (flymake-diagnostics)) (codes))
    (goto-char (point-min))
    (search-forward "link upper")
    (backward-char 2)
    (let ((hover (jsonrpc-request (eglot-current-server) :textDocument/hover (eglot--TextDocumentPositionParams))))
      (check "hover" (string-match-p "mass 2 kg" (format "%s" hover)) hover))
    (cl-letf (((symbol-function 'y-or-n-p) (lambda (&rest _) t)))
      (eglot-rename "arm"))
    (check "rename in the robot"
           (and (string-match-p "arm via shoulder" (buffer-string)) (not (string-match-p "upper" (buffer-string))))
           (buffer-string))
    (with-current-buffer (find-file-noselect "arm.dtdsl")
      (check "rename in the list" (string-match-p "fr_arm" (buffer-string)) (buffer-string)))
    (eglot-format-buffer)
    (check "formatting" (string-match-p "\n    link arm {\n        id = 1\n" (buffer-string)) (buffer-string))
    (check "comment is kept" (string-match-p "// \U0001F916 the arm" (buffer-string)) (buffer-string))
    (find-file (expand-file-name "biped.kindsl"))
    (search-forward "Leg")
    (backward-char 2)
    (let ((part (jsonrpc-request (eglot-current-server) :textDocument/definition (eglot--TextDocumentPositionParams))))
      (check "imports from folders of the settings" (string-match-p "parts/leg.kindsl" (format "%s" part)) part))))

(let ((fault (condition-case e (progn (run) nil) (error e))))
  (check "no fault" (null fault) fault))
(let ((coding-system-for-write 'utf-8))
  (with-temp-file (getenv "RESULT")
    (insert (mapconcat #'identity (reverse checks) "\n") "\n")))
(set-process-query-on-exit-flag (or (car (process-list)) (start-process "none" nil "true")) nil)
(let ((kill-emacs-hook nil)) (kill-emacs 0))
;;; emacs.el ends here
