#!/usr/bin/env python3
"""Turn the neutral description of a blind measurement set into an Umbra scenario.

  convert.py SHARED/blind/a a    reads a/model.yaml and the times in a/measurement.csv, writes
                                 a/scenario.yaml and a/materials/*.yaml
  convert.py                     does so for a, b, c and d of the folder beside this repository

Numbers are copied as text, never rounded. Only three are worked out: a contact between the two faces
of a plate becomes a conductance per area, their two capacities one wall with a share, and the grid
of times the common step of all measurement times. Python's standard library only.
"""
import csv
import datetime
import math
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
SHARED = HERE.parents[2] / "shared" / "blind"
SETS = ("a", "b", "c", "d")

# Orbits before the first observation, with and without an interior, and the longest facet edge of a
# sphere per radius; why: README.md beside this file.
ORBITS_INTERIOR, ORBITS_BARE = 13, 2
SPHERE_FACET = 0.07


# --- the YAML of model.yaml: maps and lists in blocks, [..] and {..} in one line, scalars as text ---
class Reader:
    def __init__(self, path):
        self.path = path
        self.lines = []
        for number, raw in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            text = raw.rstrip()
            if text.strip() and not text.lstrip().startswith("#"):
                self.lines.append((number, len(text) - len(text.lstrip()), text.lstrip()))
        self.at = 0

    def fail(self, number, what):
        sys.exit(f"{self.path}:{number}: {what}")

    def flow(self, number, text):
        """A scalar, [list] or {map} of one line."""
        value, rest = self.flow_value(number, text)
        if rest.strip():
            self.fail(number, f"cannot read '{rest.strip()}'")
        return value

    def flow_value(self, number, text):
        text = text.lstrip()
        if text[:1] == "[":
            return self.flow_items(number, text[1:], "]", [])
        if text[:1] == "{":
            return self.flow_items(number, text[1:], "}", {})
        if text[:1] == '"':
            end = text.find('"', 1)
            if end < 0:
                self.fail(number, "a quote is not closed")
            return text[1:end], text[end + 1:]
        end = re.search(r"[,\]}]", text) if self.depth else None
        stop = end.start() if end else len(text)
        value = text[:stop].strip()
        return (None if value == "null" else value), text[stop:]

    depth = 0

    def flow_items(self, number, text, close, into):
        self.depth += 1
        text = text.lstrip()
        while text[:1] != close:
            if isinstance(into, dict):
                key, colon, text = text.partition(":")
                if not colon:
                    self.fail(number, f"'{key}' has no value")
                into[key.strip().strip('"')], text = self.flow_value(number, text)
            else:
                value, text = self.flow_value(number, text)
                into.append(value)
            text = text.lstrip()
            if text[:1] == ",":
                text = text[1:].lstrip()
            elif text[:1] != close:
                self.fail(number, f"'{close}' is missing")
        self.depth -= 1
        return into, text[1:]

    def block(self, indent):
        """The map or list whose lines start at `indent`."""
        is_list = self.lines[self.at][2].startswith("- ")
        into = [] if is_list else {}
        while self.at < len(self.lines):
            number, own, text = self.lines[self.at]
            if own != indent or text.startswith("- ") != is_list:
                if own > indent:
                    self.fail(number, "this line is indented too far")
                break
            if is_list:
                item = text[2:].lstrip()
                if item[:1] in "[{" or not re.match(r"[A-Za-z_]\w*:", item):
                    self.at += 1
                    into.append(self.flow(number, item))
                else:  # a map that starts on the line of its dash
                    inner = own + len(text) - len(item)
                    self.lines[self.at] = (number, inner, item)
                    into.append(self.block(inner))
                continue
            match = re.match(r'(?:"([^"]*)"|([^\s:"]+)):(?:\s+(.*))?$', text)
            if not match:
                self.fail(number, f"'{text}' is not 'key: value'")
            self.at += 1
            key, value = match.group(1) or match.group(2), match.group(3)
            if value:
                into[key] = self.flow(number, value)
            else:
                below = self.lines[self.at][1:] if self.at < len(self.lines) else (-1, "")
                nested = below[0] > indent or (below[0] == indent and below[1].startswith("- "))
                into[key] = self.block(below[0]) if nested else None
        return into


def read_model(path):
    reader = Reader(path)
    model = reader.block(0)
    if reader.at != len(reader.lines):
        reader.fail(reader.lines[reader.at][0], "this line belongs to nothing")
    if model.get("schema") != "neutral-1":
        sys.exit(f"{path}: schema is '{model.get('schema')}'; accepted: neutral-1")
    return model


def accept(path, what, value, known):
    if value not in known:
        sys.exit(f"{path}: {what} is '{value}'; accepted: {', '.join(map(str, known))}")
    return known[value] if isinstance(known, dict) else value


def read_times(path):
    """First and last measurement time, and the longest step [s] that meets them all."""
    with path.open(newline="", encoding="utf-8") as file:
        texts = sorted({row["time_utc"] for row in csv.DictReader(file)})
    times = [datetime.datetime.fromisoformat(text) for text in texts]
    step = 0
    for time in times[1:]:
        step = math.gcd(step, round((time - times[0]).total_seconds() * 1000))
    return texts[0], texts[-1], f"{step / 1000:g}"


# --- Umbra's files ---------------------------------------------------------------------------------
def flow_map(**items):
    return "{" + ", ".join(f"{key}: {value}" for key, value in items.items()) + "}"


def vector(values):
    return "[" + ", ".join(values) + "]"


def header(origin, name, what):
    return (f"# {what} of the blind set '{name}', made by scenarios/blind/convert.py from {origin}.\n"
            "# Baseline as the analyst believes it; do not edit, convert again.\n")


def zero(text):
    return text is None or float(text) == 0.0


def material_text(origin, set_name, name, m):
    lines = [header(origin, set_name, "Material").rstrip(), f"name: {name}",
             f"summary: {name} of the blind set {set_name}",
             "citation: numbers given with the set; an invented surface, not a measured one", "grey:",
             f"  solar_absorptance: {m['solar_absorptance']}",
             f"  emittance: {m['ir_emittance_total']}",
             f"  band_emissivity: [{{from_um: 8.0, to_um: 12.0, value: {m['emissivity_8_12um']}}}]",
             f"  vis_reflectance_diffuse: {m['vis_reflectance_diffuse']}"]
    if not zero(m.get("vis_specular_fresnel")):
        lines += [f"  specular_reflectance: {m['vis_specular_fresnel']}",
                  f"  beckmann_alpha: {m['vis_beckmann_alpha']}"]
    return "\n".join(lines) + "\n"


def extraction(model, face):
    text = model["materials"][face["material"]].get("electrical_extraction")
    return None if zero(text) else text


def sphere_part(model, path):
    (face,) = model["faces"]
    radius = float(model["body"]["radius_m"])
    area = 4.0 * math.pi * radius * radius
    if not abs(float(face["area_m2"]) / area - 1.0) <= 1e-8:
        sys.exit(f"{path}: area_m2 {face['area_m2']} is not that of the sphere, {area:.9f}")
    if extraction(model, face):
        sys.exit(f"{path}: extraction of a sphere is not supported")
    return [f"  - name: {face['name']}",
            f"    sphere: {{radius_m: {model['body']['radius_m']}}}",
            f"    facet_size_m: {SPHERE_FACET * radius:.6g}",
            "    lumped: true",
            f"    outside: {face['material']}",
            f"    shell: {{areal_heat_capacity_J_m2_K: {face['areal_heat_capacity_j_m2_k']}}}"]


def plate_part(model, path):
    faces = {face["name"]: face for face in model["faces"]}
    front, back = faces["front"], faces["back"]
    x, y, _ = model["body"]["dimensions_xyz_m"]
    area = float(x) * float(y)
    for face in (front, back):
        if not abs(float(face["area_m2"]) / area - 1.0) <= 1e-8:
            sys.exit(f"{path}: area_m2 {face['area_m2']} is not that of the plate, {area:.9f}")
    if extraction(model, back) or model["interior"] is not None or len(model["edges"]) != 1:
        sys.exit(f"{path}: a plate has one contact, no interior, and cells on its front")
    capacity = [float(face["areal_heat_capacity_j_m2_k"]) for face in (front, back)]
    total = capacity[0] + capacity[1]
    wall = flow_map(areal_heat_capacity_J_m2_K=f"{total:.15g}",
                    front_share=f"{capacity[0] / total:.15g}",
                    through_conductance_W_m2_K=
                    f"{float(model['edges'][0]['conductance_w_k']) / area:.15g}")
    lines = ["  - name: plate", f"    plate: {{size_m: {vector([x, y])}}}", "    lumped: true",
             f"    front: {front['material']}", f"    back: {back['material']}", f"    shell: {wall}"]
    if extraction(model, front):
        lines.append(f"    electrical_extraction: {extraction(model, front)}")
    return lines


def box_part(model, path):
    lines = ["  - name: body",
             f"    box: {{size_m: {vector(model['body']['dimensions_xyz_m'])}}}", "    lumped: true",
             "    materials:"]
    size = [float(text) for text in model["body"]["dimensions_xyz_m"]]
    for face in model["faces"]:
        axis = "xyz".index(face["name"][1])
        area = size[(axis + 1) % 3] * size[(axis + 2) % 3]
        if not abs(float(face["area_m2"]) / area - 1.0) <= 1e-8 or extraction(model, face):
            sys.exit(f"{path}: face {face['name']}: area_m2 is not {area:.9f}, or it has cells that "
                     "extract, which only the front of a plate can")
        lines.append(f'      "{face["name"]}": {face["material"]}')
    inside = flow_map(capacity_J_K=model["interior"]["heat_capacity_j_k"],
                      power_W=model["interior"]["power_w"])
    lines.append(f"    interior: {inside}")
    lines.append("    groups:")
    for face in model["faces"]:
        lines.append(f'      "{face["name"]}":')
        capacity = face["areal_heat_capacity_j_m2_k"]
        if not zero(face["mli_effective_emittance"]):
            if not zero(face["conductance_to_interior_w_k"]):
                sys.exit(f"{path}: face {face['name']} has MLI and a conductance to the interior")
            mli = flow_map(effective_emittance=face["mli_effective_emittance"],
                           areal_heat_capacity_J_m2_K=capacity, wraps="interior")
            lines.append(f"        mli: {mli}")
        else:
            lines.append(f"        shell: {{areal_heat_capacity_J_m2_K: {capacity}}}")
            lines.append(f"        interior_conductance_W_K: {face['conductance_to_interior_w_k']}")
    lines.append("contacts:")
    for edge in model["edges"]:
        lines.append(f'  - {{a: "body.{edge["a"]}", b: "body.{edge["b"]}", '
                     f"conductance_W_K: {edge['conductance_w_k']}}}")
    return lines


def attitude_lines(model, path):
    mode = accept(path, "attitude.mode", model["attitude"]["mode"], ("nadir", "inertial_fixed"))
    if mode == "nadir":
        return ["  - lvlh: {roll_deg: 0, pitch_deg: 0, yaw_deg: 0}"]
    # Turning a vector from body to GCRS by q v q* is the passive rotation GCRS to body by q.
    return [f"  - fixed: {{q_gcrs: {vector(model['attitude']['quaternion_body_to_gcrs_wxyz'])}}}"]


def environment_line(model, path):
    sun, earth = model["sun"], model["earth"]
    items = {"solar_irradiance_W_m2": sun["tsi_w_m2_at_1au"], "solar_spectrum": "black_body",
             "solar_temperature_K": sun["temperature_k"], "albedo": earth["albedo"],
             "olr_W_m2": earth["olr_w_m2"],
             "brightness_temperature_K": earth["brightness_temperature_8_12um_k"],
             "earth_radius_km": earth["load_radius_km"],
             "shadow": accept(path, "earth.shadow_shape", earth["shadow_shape"],
                              {"wgs84": "oblate", "sphere": "sphere"}),
             "disc": accept(path, "sun.disc", sun["disc"], ("uniform", "point"))}
    if "shadow_radius_km" in earth:
        items["shadow_radius_km"] = earth["shadow_radius_km"]
    return [f"  {key}: {value}" for key, value in items.items()]


def scenario_text(origin, name, path, model, times):
    optics, station = model["optics"], model["station"]
    for key, value in (("earthshine_vis", "true"), ("earth_reflection_lwir", "true"),
                       ("solar_reflection_lwir", "true"), ("atmosphere", "none")):
        accept(path, f"optics.{key}", optics[key], (value,))
    accept(path, "orbit.propagator", model["orbit"]["propagator"], ("sgp4_wgs72",))
    part = accept(path, "body.shape", model["body"]["shape"],
                  {"sphere": sphere_part, "plate": plate_part, "box": box_part})
    orientation, (start, stop, step) = model["earth_orientation"], times
    used = sorted({face["material"] for face in model["faces"]})
    orbits = ORBITS_BARE if model["interior"] is None else ORBITS_INTERIOR
    lines = [header(origin, name, "Scenario").rstrip(), "schema: 1", f"name: {model['name']}",
             f"summary: Blind set {name}, its baseline.", "",
             f"time: {{start_utc: {start}Z, stop_utc: {stop}Z, step_s: {step}, light_time: false}}", "",
             "orbit:", "  tle: |", f"    {model['orbit']['tle_line1']}",
             f"    {model['orbit']['tle_line2']}",
             f"  earth_orientation: {flow_map(**orientation)}", "", "attitude:",
             *attitude_lines(model, path), "", "observer:", f"  station: {flow_map(**station)}", "",
             "environment:", *environment_line(model, path), "", "material_files:",
             *(f"  - materials/{material}.yaml" for material in used), "", "parts:",
             *part(model, path), "",
             f"thermal: {{orbits_before: {orbits}, start: periodic}}", "", "bands:"]
    for band, bins in (("vis", 80), ("lwir", 40)):
        low, high = optics[f"{band}_band_um"]
        lines.append(f"  {band}: {{from_um: {low}, to_um: {high}, bins: {bins}}}")
    return "\n".join(lines) + "\n", used


def convert(folder, out):
    path, name = folder / "model.yaml", folder.name
    model = read_model(path)
    origin = f"shared/blind/{name}/model.yaml"
    text, used = scenario_text(origin, name, path, model, read_times(folder / "measurement.csv"))
    (out / "materials").mkdir(parents=True, exist_ok=True)
    (out / "scenario.yaml").write_text(text, encoding="utf-8")
    for material in used:
        (out / "materials" / f"{material}.yaml").write_text(
            material_text(origin, name, material, model["materials"][material]), encoding="utf-8")


def main():
    if len(sys.argv) == 1:
        for name in SETS:
            convert(SHARED / name, HERE / name)
    elif len(sys.argv) == 3:
        convert(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]))
    else:
        sys.exit(__doc__)


main()
