"""Plants mistakes in the sample tracers and writes their logs, which the tests of `raystep check` read.

usage: python3 plant.py OUT [NAME ...]       from any folder; needs c++ for the names that begin with cpp-

Each mistake is an edit of a sample's text: what stands there, and what a student writes instead.
"""

import gzip
import json
import pathlib
import subprocess
import sys
import tempfile

SAMPLES = pathlib.Path(__file__).resolve().parents[3] / "lessons" / "any-language"
PIXELS = ["0,0", "7,6", "15,7", "17,8", "18,3", "1,9", "19,10", "10,6"]
# where rays go to and fro between the mirror and the floor
DEEP = ["0,0", "7,6", "16,12", "17,12", "15,13", "14,14", "16,14", "15,15"]
# shadows on the floor
SHADOWS = ["0,0", "7,6", "19,10", "5,11", "12,11", "14,12", "17,13", "17,14"]

ANGLE = 'math.tan(math.radians(look["fov_degrees"]) / 2)'
PLACE = """        right = (x + half - self.width / 2) * self.pixel
        up = (self.height / 2 - (y + half)) * self.pixel"""
LIMIT = 'depth < self.scene.get("max_depth", 5)'
MIRRORED = "mirrored = add(direction, mul(factor * dot(normal, direction), normal))"
SHADOW = """            blocked = self.nearest(shadow, point, to, least, most)"""
SUM = "sum_ = add(ambient, direct)"
PYTHON = {
    "tan-of-the-whole-angle": [(ANGLE, 'math.tan(math.radians(look["fov_degrees"]))')],
    "degrees-for-radians": [(ANGLE, 'math.tan(look["fov_degrees"] / 2)')],
    "u-and-v-swapped": [(PLACE, PLACE.replace("(x + half", "((y + half) * self.width / self.height")
                         .replace("(y + half)", "((x + half) * self.height / self.width)", 2)
                         .replace("(((x + half) * self.height / self.width) *", "((y + half) *"))],
    "w-turned": [("add(self.cop, add(self.ahead,", "add(self.cop, add(mul(-1, self.ahead),")],
    "n-minus-1": [(PLACE, PLACE.replace("x + half", "(x + half) * self.width / (self.width - 1)")
                   .replace("(y + half)", "(y + half) * self.height / (self.height - 1)"))],
    "aspect-twice": [(PLACE, PLACE.replace("* self.pixel", "* self.pixel * self.width / self.height", 1))],
    "not-divided-by-r": [('mul(1 / ball["radius"], sub(point, ball["center"]))', 'sub(point, ball["center"])')],
    "limit-one-too-high": [(LIMIT, LIMIT.replace("<", "<="))],
    "limit-one-too-low": [(LIMIT, LIMIT.replace("depth <", "depth + 1 <"))],
    "background-at-the-limit": [("        return sum_\n", """        elif weight > 0:
            sum_ = add(sum_, mul(weight, self.scene["background"]))
        return sum_
""")],
    "no-shadow-ray": [(SHADOW, "            blocked = None")],
    "n-not-unit": [(MIRRORED, "long = mul(1 / max(abs(x) for x in normal), normal)\n            "
                    + MIRRORED.replace("normal", "long"))],
    "d-turned": [(MIRRORED, MIRRORED.replace("add(direction, mul(factor", "add(mul(-1, direction), mul(-factor"))],
    "ambient-in-the-loop": [(SUM, 'sum_ = add(mul(len(self.scene["lights"]), ambient), direct)')],
    "stops-at-the-first-leaf": [("                found = (t, thing)\n", "                return (t, thing)\n")],
}
# a tracer of another make: rays start 1e-4 beside their surface, and each direction is divided by its length
BESIDE = [("        material = self.scene[", "        point = add(point, mul(1e-4, normal))\n        material = self.scene["),
          ("mul(factor * dot(normal, direction), normal))", "mul(factor * dot(normal, direction), normal))\n"
           "            mirrored = unit(mirrored)"),
          ("0 if depth == 1 else EPSILON", "0"), ('least = 0 if MISTAKE == "no ε" else EPSILON', "least = 0")]
COLOURS = {
    "plus-2": [*BESIDE, ('MISTAKE = ""', 'MISTAKE = "plus 2"')],
    "no-weight": [*BESIDE, ('MISTAKE = ""', 'MISTAKE = "no weight"')],
    "right": BESIDE,
}
CPP = {
    "offset-to-the-wrong-side": [("p + EPSILON * normal", "p - EPSILON * normal")],
}


def planted(sample, edits):
    text = (SAMPLES / sample).read_text()
    for old, new in edits:
        assert text.count(old) == 1, (sample, old, text.count(old))
        text = text.replace(old, new)
    return text


def run(name, pixels):
    """The log of a planted tracer."""
    language, mistake = name.split("-", 1)
    scene = json.loads((SAMPLES / "scene.json").read_text())
    if "limit" in name:
        scene["max_depth"] = 2
    if "first-leaf" in name:
        # the nearer objects come last
        scene["objects"].reverse()
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "scene.json"
        file.write_text(json.dumps(scene))
        scene = str(file)
        if language in ["python", "colours"]:
            file = pathlib.Path(folder) / "tracer.py"
            file.write_text(planted("tracer.py", (PYTHON if language == "python" else COLOURS)[mistake]))
            command = [sys.executable, str(file)]
        else:
            file = pathlib.Path(folder) / "tracer.cpp"
            file.write_text(planted("tracer.cpp", CPP[mistake]))
            program = str(pathlib.Path(folder) / "tracer")
            subprocess.run(["c++", "-std=c++17", "-O1", str(file), "-o", program], check=True)
            command = [program]
        if language == "colours":
            # the whole picture, and nothing but its colours
            pixels = []
        log = subprocess.run([*command, scene, *pixels], check=True, capture_output=True).stdout
        lines = log.splitlines(keepends=True)
        return b"".join(line for line in lines if language != "colours" or b"pixel_colour" in line)


def main():
    out = pathlib.Path(sys.argv[1])
    names = sys.argv[2:] or [
        f"{language}-{name}"
        for language, mistakes in [("python", PYTHON), ("colours", COLOURS), ("cpp", CPP)]
        for name in mistakes
    ]
    for name in names:
        log = run(name, DEEP if "limit" in name else SHADOWS if "shadow" in name else PIXELS)
        with open(out / f"{name}.jsonl.gz", "wb") as raw, gzip.GzipFile("", "wb", 9, raw, 0) as file:
            file.write(log)


if __name__ == "__main__":
    main()
