"""Pages of the reference, made from what the program and its header say: commands, keys, effects,
materials, filters, sensors, C. Nothing here is a list of its own."""
import json
import os
import pathlib
import re
import subprocess

# How the program is asked. Everything that names a command of it stands here.
ASK = {
    "help": ["help"],
    "keys": ["list", "keys"],
    "materials": ["list", "materials"],
    "filters": ["list", "filters"],
    "sensors": ["list", "sensors"],
}


class Program:
    def __init__(self, path):
        self.path = path

    def ask(self, what, *more):
        command = [str(self.path), *ASK[what], *more]
        environment = {"ASAN_OPTIONS": "detect_leaks=0", **os.environ}  # of a build with sanitizers
        done = subprocess.run(command, capture_output=True, text=True, timeout=300, env=environment)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(command)}: {done.stderr.strip()}")
        return done.stdout


def put(folder, name, text):
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return name


def block(text, kind="text"):
    return f"```{kind}\n{text.rstrip()}\n```\n"


def json_values(schema, at=""):
    """Path, types and meaning of every value that a schema describes."""
    if "description" in schema:
        types = schema["type"] if isinstance(schema["type"], list) else [schema["type"]]
        yield at, " or ".join(types), schema["description"]
    for name, inside in schema.get("properties", {}).items():
        path = f"{at}.{name}" if at else name
        yield from json_values(inside, path if name in schema["required"] else path + "?")
    if "items" in schema:
        yield from json_values(schema["items"], f"{at}[]")
    if isinstance(schema.get("additionalProperties"), dict):
        yield from json_values(schema["additionalProperties"], f"{at}.*")


def json_tables(program, folder, name):
    """What a command prints with --json, as tables; its JSON Schema stands beside the page."""
    schema = json.loads(program.ask("help", name, "--json"))["answer"]
    put(folder, f"reference/commands/{name}.schema.json", json.dumps(schema, indent=1) + "\n")
    text = (f"\n## With `--json`\n\nAs [JSON Schema]({name}.schema.json). `[]` is a list, `*` a name, `?` is not always "
            "there.\n")
    for answer in schema["anyOf"]:
        text += f"\n{answer['title']}:\n" if "title" in answer else ""
        text += "\n| key | type | |\n|---|---|---|\n"
        text += "".join(f"| `{path}` | {types} | {what} |\n" for path, types, what in json_values(answer))
    return text


def commands(program, folder):
    """A page a command, with its help and what it prints with --json, in the order of the program."""
    pages = []
    for command in json.loads(program.ask("help", "--json"))["commands"]:
        name = command["name"]
        text = f"# umbra {name}\n\n" + block(program.ask("help", name)) + json_tables(program, folder, name)
        pages.append({name: put(folder, f"reference/commands/{name}.md", text)})
    index = "# Commands\n\nWhat `umbra help` prints. `umbra help COMMAND` prints the page of one.\n\n"
    put(folder, "reference/commands/README.md", index + block(program.ask("help")))
    return ["reference/commands/README.md", *pages]


def keys(program, folder):
    head = (
        "# Keys of a scenario\n\nWhat `umbra list keys` prints. `umbra list keys PATH` prints a section, "
        "`umbra list keys --json` a JSON Schema for [editors](../docs/howto/editor.md).\n\n"
    )
    # Sections of the program's own page are one level lower here.
    text = re.sub(r"^(#+ )", r"#\1", program.ask("keys"), flags=re.M)
    put(folder, "reference/keys.md", head + text)


def number(value):
    return "-" if value is None else f"{value:.3f}"


def measured(record):
    """What a record claims to be measured, and what lies outside."""
    if record["measured_from_um"] is None:
        return "No measured constants or reflectance: the numbers are chosen, as the citation says."
    return (
        f"Measured from {record['measured_from_um']:.4g} to {record['measured_to_um']:.4g} µm. Constant outside, "
        f"if the citation says nothing else: {100 * record['solar_outside']:.2f} % of sunlight, "
        f"{100 * record['heat_outside']:.1f} % of the heat of 300 K."
    )


def published(value, tolerance):
    return "-" if value is None else f"{value:.3f} ± {tolerance:.3f}"


def ageing(record):
    text = ""
    for a in record["ageing"]:
        text += f"- After {a['after']}:"
        if a["solar_absorptance_change"] is not None:
            shift = a["solar_absorptance_change"]
            text += f" solar absorptance {shift:+.3g}, as `--with solar_absorptance:{record['name']},shift={shift:g}`."
        if a["emittance_change"] is not None:
            text += f" Emittance {a['emittance_change']:+.3g}."
        text += f" {a['source']}\n"
    return "\n## Ageing\n\n" + text if text else ""


def material_page(program, record):
    name = record["name"]
    row = "| {} | {} | {} |\n".format
    solar = published(record["catalogue_solar_absorptance"], record["catalogue_solar_absorptance_tolerance"])
    heat = published(record["catalogue_emittance"], record["catalogue_emittance_tolerance"])
    text = f"# {name}\n\n{record['summary']}\n\n![Reflectance over wavelength]({name}.svg)\n\n"
    text += f"{measured(record)} The curves as a table: [{name}.csv]({name}.csv).\n\n"
    text += "| | of the record | catalogue |\n|---|---|---|\n"
    text += row("solar absorptance, ASTM E490, normal incidence", number(record["solar_absorptance"]), solar)
    normal = record["catalogue_emittance_is_normal"]
    text += row("emittance at 300 K, hemispherical", number(record["emittance"]), "-" if normal else heat)
    text += row("emittance at 300 K, normal", number(record["normal_emittance"]), heat if normal else "-")
    text += f"\nCatalogue: {record['catalogue_source']}\n" if record["catalogue_source"] else ""
    text += ageing(record)
    return text + f"\n## Citation\n\n{record['source']}\n\n## As printed\n\n" + block(program.ask("materials", name))


def materials(program, folder):
    """A page a record with its spectrum, as `umbra list materials --out` draws it."""
    records = json.loads(program.ask("materials", "--json"))
    spectra = folder / "reference/materials"
    spectra.parent.mkdir(parents=True, exist_ok=True)
    program.ask("materials", "--out", str(spectra))
    for file in spectra.iterdir():
        if file.suffix not in (".svg", ".csv"):
            file.unlink()
    text = (
        "# Materials\n\nRecords that come with the program, as `umbra list materials` has them: solar absorptance "
        "over ASTM E490 at normal incidence; emittance of 300 K, hemispherical and normal; the wavelengths between "
        "which n and k, or reflectances, are measured. How a record is written: "
        "[material records](../../materials/library/README.md).\n\n"
        "| material | absorptance | catalogue | emittance | normal | catalogue | measured [µm] |\n"
        "|---|---|---|---|---|---|---|\n"
    )
    pages = []
    for r in records:
        row = [
            f"[{r['name']}]({r['name']}.md)",
            number(r["solar_absorptance"]),
            number(r["catalogue_solar_absorptance"]),
            number(r["emittance"]),
            number(r["normal_emittance"]),
            number(r["catalogue_emittance"]),
            "-" if r["measured_from_um"] is None else f"{r['measured_from_um']:.3g} - {r['measured_to_um']:.3g}",
        ]
        text += "| " + " | ".join(row) + " |\n"
        pages.append({r["name"]: put(folder, f"reference/materials/{r['name']}.md", material_page(program, r))})
    put(folder, "reference/materials/README.md", text)
    return ["reference/materials/README.md", *pages]


def instruments(program, folder):
    text = "# Filters and sensors\n\n## Filters\n\nWhat `umbra list filters` prints.\n\n"
    text += block(program.ask("filters")) + "\n## Sensors\n\nWhat `umbra list sensors` prints.\n\n"
    listed = program.ask("sensors")
    text += block(listed)
    for line in listed.splitlines():
        name = line.split()[0]
        text += f"\n### {name}\n\n" + block(program.ask("sensors", name), "yaml")
    put(folder, "reference/instruments.md", text)


def effects(folder):
    """docs/effects.md, which a test holds to the descriptors, as a page an effect."""
    manual = folder / "docs/effects.md"
    head, *parts = re.split(r"^## ", manual.read_text(encoding="utf-8"), flags=re.M)
    pages = []
    for part in parts:
        name, text = part.split("\n", 1)
        text = text.replace("](#", "](")
        text = re.sub(r"\]\(([a-z_]+)\)", r"](\1.md)", text)
        pages.append({name: put(folder, f"docs/effects/{name}.md", f"# {name}\n{text}")})
    manual.write_text(re.sub(r"\]\(#([a-z_]+)\)", r"](effects/\1.md)", head), encoding="utf-8")
    return ["docs/effects.md", *pages]


def comment_text(comment):
    lines = comment.strip()[2:-2].split("\n")
    lines = [re.sub(r"^ *\* ?", "", line) if i else line.lstrip() for i, line in enumerate(lines)]
    text = "\n".join(lines).strip()
    text = re.sub(r"\b(umbra_[a-z_]+|UMBRA_[A-Z_0-9]+)\b", r"`\1`", text)
    return re.sub(r"([*<])", r"\\\1", text)


def c_interface(header, folder):
    """The contracts of umbra.h in its order: a comment at the margin, then what it is about."""
    source = header.read_text(encoding="utf-8")
    text = "# C interface\n\nThe contracts of `umbra.h`, in the order of the header. [An example](../examples/c/lightcurve.c).\n"
    for piece in re.split(r"(^/\*.*?\*/$)", source, flags=re.M | re.S):
        title = re.match(r"/\* --- (.*?) -+ \*/", piece)
        if title:
            text += f"\n## {title.group(1)}\n"
        elif piece.startswith("/*"):
            text += f"\n{comment_text(piece)}\n"
        else:
            code = re.sub(r"^#(if|ifndef|ifdef|endif|include|define UMBRA_UMBRA_H).*$", "", piece, flags=re.M)
            code = re.sub(r'^extern "C" \{$|^\}$', "", code, flags=re.M)
            code = re.sub(r"\n{3,}", "\n\n", code).strip("\n")
            if code.strip():
                text += "\n" + block(code, "c")
    put(folder, "reference/c.md", text)


def everything(program, header, folder):
    """All pages into the folder; the lists that the navigation wants, by name."""
    program = Program(program)
    keys(program, folder)
    instruments(program, folder)
    c_interface(pathlib.Path(header), folder)
    return {"commands": commands(program, folder), "effects": effects(folder), "materials": materials(program, folder)}
