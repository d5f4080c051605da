"""What the user sees on stderr: progress, and the generator's warnings and notes."""
import re
import sys
import time

_START = re.compile(r"^(?:.*?: )?(error|warning|note): ")
_printed = set()


def report(messages, is_new, quiet):
    """Prints messages of the generator. Those that come from the cache are printed once in a process, and without notes."""
    blocks = []
    for line in messages.strip().splitlines():
        start = None if line.startswith((" ", "hint:")) else _START.match(line)
        if start or not blocks:
            blocks.append((start[1] if start else "", []))
        blocks[-1][1].append(line)
    for kind, lines in blocks:
        text = "\n".join(lines)
        is_wanted = is_new or text not in _printed
        if kind == "note":
            is_wanted = is_new and not quiet
        _printed.add(text)
        if is_wanted:
            print(text, file=sys.stderr)


class Progress:
    """A line a phase, or a bar if there is tqdm."""

    def __init__(self, name, quiet):
        self.name, self.quiet, self.bar, self.start = name, quiet, None, time.monotonic()

    def begin(self, phase, steps):
        if self.quiet:
            return
        try:
            from tqdm.auto import tqdm
            self.bar = tqdm(total=steps, desc=f"robcogen: {self.name}: {phase}", file=sys.stderr, leave=False)
        except ImportError:
            self.say(phase)

    def step(self):
        if self.bar is not None:
            self.bar.update()

    def close(self):
        if self.bar is not None:
            self.bar.close()

    def end(self):
        self.say(f"ready after {time.monotonic() - self.start:.1f} s")

    def say(self, text):
        if not self.quiet:
            print(f"robcogen: {self.name}: {text}", file=sys.stderr, flush=True)
