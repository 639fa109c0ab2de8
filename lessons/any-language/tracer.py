"""A ray tracer for lessons 02 to 07 that writes its working: spheres, polygons, shadows, reflection.

usage: python3 tracer.py SCENE.json > log.jsonl        then: raystep check SCENE.json log.jsonl
       python3 tracer.py SCENE.json X,Y X,Y            some pixels only
"""

import json
import math
import sys
EPSILON = 1e-9
MISTAKE = ""  # a test plants one of those that the code below names


def add(a, b): return [x + y for x, y in zip(a, b)]
def sub(a, b): return [x - y for x, y in zip(a, b)]
def mul(k, a): return [k * x for x in a]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
def unit(a): return mul(1 / math.sqrt(dot(a, a)), a)


def log(kind, pixel, ray=None, **fields):
    line = {"kind": kind, "pixel": pixel}
    if ray is not None:
        line["ray"] = ray
    line.update((key, value) for key, value in fields.items() if value is not None)
    print(json.dumps(line))


class Camera:
    """The window at a distance of 1 before the COP."""
    def __init__(self, scene):
        look = scene["camera"]["look_at"]
        self.cop, (self.width, self.height) = look["cop"], scene["camera"]["pixels"]
        self.ahead = unit(sub(look["target"], self.cop))
        self.right = unit(cross(self.ahead, look["up"]))
        self.up = cross(self.right, self.ahead)
        self.pixel = 2 * math.tan(math.radians(look["fov_degrees"]) / 2) / self.height

    def ray(self, x, y):
        half = 0 if MISTAKE == "no ½" else 0.5
        right = (x + half - self.width / 2) * self.pixel
        up = (self.height / 2 - (y + half)) * self.pixel
        up *= -1 if MISTAKE == "row from below" else 1
        point = add(self.cop, add(self.ahead, add(mul(right, self.right), mul(up, self.up))))
        return point, unit(sub(point, self.cop))


def sphere_t(ball, origin, direction, least, tell):
    """Equation (iii)."""
    oc = sub(origin, ball["center"])
    oc = mul(-1, oc) if MISTAKE == "c − o without the turned sign" else oc
    a, b, c = dot(direction, direction), 2 * dot(direction, oc), dot(oc, oc) - ball["radius"] ** 2
    if MISTAKE == "half b in the full formula":
        b /= 2
    discriminant = b * b - 4 * a * c
    t = near = far = None
    if discriminant >= 0:
        near, far = (-b - math.sqrt(discriminant)) / (2 * a), (-b + math.sqrt(discriminant)) / (2 * a)
        t = next((t for t in (near, far) if t > least), None)
        if MISTAKE == "first root always":
            t = near
        if MISTAKE == "largest root":
            t = far if far > least else None
    tell("sphere_test", a=a, b=b, c=c, discriminant=discriminant, near=near, far=far, t=t)
    return t


def polygon_t(polygon, origin, direction, least, tell):
    """Equations (iv) and (v), then Fig. 15.57."""
    corners = polygon["vertices"]
    normal = unit(cross(sub(corners[1], corners[0]), sub(corners[2], corners[0])))
    above = dot(normal, sub(origin, corners[0]))
    down = dot(normal, direction)
    if abs(down) < 1e-12:
        return None
    t = -above / down
    is_ahead = t > least or MISTAKE == "negative t kept"
    tell("plane_test", plane=normal + [-dot(normal, corners[0])], numerator=above, denominator=down, root=t,
         verdict="hit" if is_ahead else "rejected", t=t if is_ahead else None)
    if not is_ahead:
        return None
    point = add(origin, mul(t, direction))
    size = [abs(x) for x in normal]
    drop = size.index((min if MISTAKE == "axis of the smallest coefficient" else max)(size))
    u, v = [axis for axis in range(3) if axis != drop]
    crossings = 0
    for i, to in enumerate(corners):
        start = corners[i - 1]
        if (start[v] > point[v]) != (to[v] > point[v]):
            at = start[u] + (point[v] - start[v]) / (to[v] - start[v]) * (to[u] - start[u])
            crossings += at > point[u]
    inside = crossings % 2 == 1
    tell("polygon_test", dropped="xyz"[drop], point=point, crossings=crossings, inside=inside)
    return t if inside else None


class Tracer:
    def __init__(self, scene):
        self.scene, self.camera = scene, Camera(scene)
    def start(self, purpose, origin, direction, parent=None, light=None):
        self.rays += 1
        log("ray", self.pixel, self.rays - 1, parent=parent, purpose=purpose, origin=origin, direction=direction, light=light)
        return self.rays - 1

    def nearest(self, ray, origin, direction, least, most=math.inf):
        found = None
        for thing in self.scene["objects"]:
            def tell(kind, **fields):
                log(kind, self.pixel, ray, object=thing["name"], **fields)
            shape = thing["shape"]
            if "sphere" in shape:
                t = sphere_t(shape["sphere"], origin, direction, least, tell)
            else:
                t = polygon_t(shape["polygon"], origin, direction, least, tell)
            is_nearer = found is None or t is None or t < found[0] or MISTAKE == "last hit wins"
            if t is not None and t < most and is_nearer:
                found = (t, thing)
        return found

    def colour(self, ray, origin, direction, depth):
        found = self.nearest(ray, origin, direction, 0 if depth == 1 else EPSILON)
        if found is None:
            return self.scene["background"]
        t, thing = found
        log("nearest", self.pixel, ray, object=thing["name"], t=t)
        point, shape = add(origin, mul(t, direction)), thing["shape"]
        if "sphere" in shape:
            ball = shape["sphere"]
            normal = mul(1 / ball["radius"], sub(point, ball["center"]))
            if MISTAKE == "p instead of p − c":
                normal = unit(point)
        else:
            corners = shape["polygon"]["vertices"]
            normal = unit(cross(sub(corners[1], corners[0]), sub(corners[2], corners[0])))
        if dot(normal, direction) > 0:
            normal = mul(-1, normal)
        material = self.scene["materials"][thing["material"]]
        own = material["colour"]
        ambient, direct = [a * c for a, c in zip(self.scene.get("ambient", [0, 0, 0]), own)], [0, 0, 0]
        for light in self.scene.get("lights", []):
            direct = add(direct, self.light_term(ray, light, material, point, normal, direction))
        log("shade", self.pixel, ray, object=thing["name"], point=point, normal=normal, ambient=ambient, direct=direct)
        sum_ = add(ambient, direct)
        weight = material.get("reflection", 0)
        if weight > 0 and depth < self.scene.get("max_depth", 5):
            factor = -2 if MISTAKE != "plus 2" else 2
            mirrored = add(direction, mul(factor * dot(normal, direction), normal))
            child = self.start("reflected", point, mirrored, parent=ray)
            brought = self.colour(child, point, mirrored, depth + 1)
            sum_ = add(sum_, mul(1 if MISTAKE == "no weight" else weight, brought))
        return sum_

    def light_term(self, ray, light, material, point, normal, incoming):
        to = sub(light["position"], point)
        if MISTAKE == "L from light to point":
            to = mul(-1, to)
        distance, to = math.sqrt(dot(to, to)), unit(to)
        cosine = dot(normal, to)
        mirrored = sub(mul(2 * cosine, normal), to)
        highlight = dot(mirrored, mul(-1, incoming))
        colours = list(zip(light["colour"], material["colour"]))
        diffuse = [l * c * material.get("diffuse", 0) * max(0, cosine) for l, c in colours]
        shine = material.get("specular", 0) * max(0, highlight) ** material.get("shininess", 1) if cosine > 0 else 0
        specular = [l * shine for l, _ in colours]
        visibility = "faces_away"
        if cosine > 0:
            shadow = self.start("shadow", point, to, parent=ray, light=light["name"])
            most = math.inf if MISTAKE == "any hit counts" else distance * (1 - EPSILON)
            least = 0 if MISTAKE == "no ε" else EPSILON
            blocked = self.nearest(shadow, point, to, least, most)
            visibility = "shadowed" if blocked else "visible"
        log("light_term", self.pixel, ray, light=light["name"], visibility=visibility, to_light=to, distance=distance,
            n_dot_l=cosine, r_dot_v=highlight, diffuse=diffuse, specular=specular)
        return add(diffuse, specular) if visibility == "visible" else [0, 0, 0]

    def trace(self, x, y):
        self.pixel, self.rays = [x, y], 0
        point, direction = self.camera.ray(x, y)
        log("pixel", self.pixel, point=point)
        ray = self.start("eye", self.camera.cop, direction)
        raw = self.colour(ray, self.camera.cop, direction, 1)
        log("pixel_colour", self.pixel, raw=raw)


def main():
    with open(sys.argv[1]) as file:
        tracer = Tracer(json.load(file))
    for word in sys.argv[2:]:
        tracer.trace(*map(int, word.split(",")))
    if len(sys.argv) > 2:
        return
    for y in range(tracer.camera.height):
        for x in range(tracer.camera.width):
            tracer.trace(x, y)


if __name__ == "__main__":
    main()
