"""What the tests share: the modules, and what the generator's interpreter says of the same states."""
import json
import os
import subprocess
import sys

import numpy as np

import arm
import ball_leg
import leg
import walker

ROBOTS = os.path.join(os.environ["ROBCOGEN_SOURCE_DIR"], "robots")
CONTACTS = {walker: ["--contacts", "fr_foot"]}
MODELS = {arm: "iiwa14", leg: "hyl_parametric", walker: "geared_leg", ball_leg: "ball_leg"}
five_bar = None
if os.environ["ROBCOGEN_TEST_EVERYTHING"] == "1":  # else it is not compiled
    import five_bar
    MODELS[five_bar] = "five_bar"
RANDOM = np.random.default_rng(5)


def scopes(module, prefix=""):
    """All functions of a module, by the names that `eval` knows."""
    for name, item in vars(module).items():
        if name.startswith("_"):
            continue
        if type(item).__name__ == "builtin_function_or_method":
            yield prefix + name, item
        elif type(item).__name__ == "module":
            yield from scopes(item, prefix + name + ".")


def random_values(module, name, shape):
    """Between -1 and 1, positions nearer to 0 where loops must close; those of spherical joints are unit quaternions."""
    values = RANDOM.uniform(-1, 1, shape)
    if name == "q" and module is five_bar:
        values *= 0.4
    for k, element in enumerate(module.position_names) if name in ("q", "q_from", "q_to") else ():
        if element not in module.joint_names:
            values[..., k : k + 4] /= np.linalg.norm(values[..., k : k + 4], axis=-1, keepdims=True)
    return values


def plain(value):
    return value if isinstance(value, dict) else np.asarray(value).tolist()


def evaluate(module, function, states, *options):
    """The results of `robcogen eval`, a dictionary a state."""
    model = os.path.join(ROBOTS, MODELS[module], MODELS[module])
    command = [os.environ["ROBCOGEN_TOOL"], "eval", "--quiet", model + ".kindsl", function, "--desired", model + ".dtdsl", *CONTACTS.get(module, []), *options]
    text = "\n".join(json.dumps({k: plain(v) for k, v in s.items()}) for s in states)
    run = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    if run.returncode:
        sys.exit(f"{function}: {run.stderr}")
    return [json.loads(line) for line in run.stdout.splitlines()]


def rss():
    """The memory of this process, in bytes."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
