"""The JSON Schema that `umbra list keys --json` prints is one, takes every scenario that comes with the
program, as an editor would read it, and refuses what the program refuses.

    schema.py UMBRA HOUSE
"""
import copy
import json
import pathlib
import re
import subprocess
import sys

import jsonschema
import yaml


class Loader(yaml.SafeLoader):
    """YAML 1.2, as editors read it: times are texts, `off` is a word, 1e-3 is a number."""


Loader.yaml_implicit_resolvers = {
    first: [(tag, pattern) for tag, pattern in resolvers
            if tag.rsplit(":", 1)[1] not in ("timestamp", "bool", "float")]
    for first, resolvers in copy.deepcopy(yaml.SafeLoader.yaml_implicit_resolvers).items()}
Loader.add_implicit_resolver("tag:yaml.org,2002:bool", re.compile("^(?:true|false)$"), list("tf"))
Loader.add_implicit_resolver(
    "tag:yaml.org,2002:float",
    re.compile(r"^[-+]?(?:\d+\.\d*|\.\d+|\d+(?=[eE]))(?:[eE][-+]?\d+)?$"), list("-+.0123456789"))


def main():
    umbra, house = sys.argv[1], pathlib.Path(sys.argv[2])
    schema = json.loads(subprocess.run([umbra, "list", "keys", "--json"], check=True, capture_output=True).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    files = sorted(house.glob("scenarios/**/scenario.yaml")) + sorted(house.glob("tests/scenarios/data/**/scenario.yaml"))
    assert len(files) > 10
    for file in files:
        scenario = yaml.load(file.read_text(encoding="utf-8"), Loader)
        wrong = [f"{file}: {'.'.join(map(str, e.absolute_path))}: {e.message}" for e in validator.iter_errors(scenario)]
        assert not wrong, "\n".join(wrong)
    scenario = yaml.load((house / "scenarios/cube/scenario.yaml").read_text(encoding="utf-8"), Loader)
    for change in ({"nmae": "cube"}, {"time": 3}, {"orbit": {"circular": {"altitude_km": -8000}}}, {"parts": "bus"}):
        assert list(validator.iter_errors({**scenario, **change})), f"accepted: {change}"
    print(f"{len(files)} scenarios")


if __name__ == "__main__":
    main()
