;;; robcogen-mode.el --- Robot descriptions of robcogen -*- lexical-binding: t -*-

;; Package-Requires: ((emacs "27.1"))
;; Keywords: languages

;;; Commentary:

;; Modes for .kindsl, .dtdsl, .motdsl and .ctdsl, and the language server for Eglot, also for .urdf.

;;; Code:

(require 'robcogen-words)

(defgroup robcogen nil
  "Robot descriptions."
  :group 'languages)

(defcustom robcogen-command '("robcogen" "language-server")
  "The language server: the program and its arguments."
  :type '(repeat string))

(defvar robcogen-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?/ ". 124b" table)
    (modify-syntax-entry ?* ". 23" table)
    (modify-syntax-entry ?\n "> b" table)
    (modify-syntax-entry ?_ "_" table)
    (modify-syntax-entry ?\" "\"" table)
    table)
  "Comments are those of C++.")

(defun robcogen--font-lock (keywords words)
  "What to highlight in a language with these KEYWORDS and WORDS."
  `((,(regexp-opt keywords 'symbols) . font-lock-keyword-face)
    ,@(and words `((,(regexp-opt words 'symbols) . font-lock-variable-name-face)))
    (,(regexp-opt '("sin" "cos" "tan" "sqrt") 'symbols) . font-lock-function-name-face)
    ("\\_<[Pp][Ii]\\_>" . font-lock-constant-face)))

(defmacro robcogen--define (name title)
  "Define the mode of the language NAME, which people call TITLE."
  (let ((mode (intern (format "%s-mode" name))))
    `(progn
       ;;;###autoload
       (define-derived-mode ,mode prog-mode ,title
         ,(format "Major mode for documents of the %s." title)
         :syntax-table robcogen-mode-syntax-table
         (setq-local comment-start "// ")
         (setq-local comment-start-skip "\\(?://+\\|/\\*+\\)\\s *")
         (setq-local comment-end "")
         (setq-local indent-line-function #'indent-relative)
         (setq-local font-lock-defaults
                     (list (robcogen--font-lock ,(intern (format "robcogen-%s-keywords" name))
                                                ,(intern (format "robcogen-%s-words" name))))))
       (add-to-list 'auto-mode-alist '(,(format "\\.%s\\'" name) . ,mode)))))

(robcogen--define "kindsl" "Kinematics-DSL")
(robcogen--define "dtdsl" "Desired-transforms-DSL")
(robcogen--define "motdsl" "Motion-DSL")
(robcogen--define "ctdsl" "Transforms-DSL")

;;;###autoload
(define-derived-mode urdf-mode xml-mode "URDF"
  "Major mode for robots in URDF.")
(add-to-list 'auto-mode-alist '("\\.urdf\\'" . urdf-mode))

(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  (dolist (mode '(kindsl-mode dtdsl-mode motdsl-mode ctdsl-mode urdf-mode))
    (add-to-list 'eglot-server-programs (cons mode robcogen-command))))

(provide 'robcogen-mode)
;;; robcogen-mode.el ends here
