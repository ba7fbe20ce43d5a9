"""Intensity over irradiance [m^2/sr] of the facets that tests/bench/mitsuba.c has written.

render_mitsuba.py FOLDER OUT: lines `case instant value error`. Orthographic camera in the observer's direction,
film as large as the satellite; the intensity is the sum of pixels' radiance times their area. The error is that
of the mean of RUNS renderings with seeds of their own.
"""
import glob
import os
import sys

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")  # needs no LLVM; grey light has one luminance
PIXELS, SAMPLES, RUNS = 256, 9, 6
CASES = {
    "lambert": ({"type": "diffuse", "reflectance": 0.5}, 2),
    "beckmann": ({"type": "roughconductor", "material": "none", "distribution": "beckmann", "alpha": 0.2,
                  "specular_reflectance": 0.3}, 2),
    "bounce": ({"type": "diffuse", "reflectance": 0.5}, 3),
    "all": ({"type": "diffuse", "reflectance": 0.5}, -1),
    "lobes": ({"type": "roughconductor", "material": "none", "distribution": "beckmann", "alpha": 0.2,
               "specular_reflectance": 0.3}, -1),
}


def scene_of(points, two_sided, observer, sun, bsdf, depth):
    meshes = {}
    for name, of, what in (("closed", points[~two_sided], bsdf),
                           ("open", points[two_sided], {"type": "twosided", "bsdf": bsdf})):
        if len(of) > 0:
            meshes[name] = {"type": "ply", "filename": ply_of(name, of), "face_normals": True, "bsdf": what}
    centre = 0.5 * (points.min(0) + points.max(0))
    radius = np.linalg.norm(points - centre, axis=1).max() * 1.001
    up = np.eye(3)[np.argmin(np.abs(observer))]
    right = np.cross(up, observer)
    right /= np.linalg.norm(right)
    up = np.cross(observer, right)
    wide, high = (1.001 * np.abs((points - centre) @ axis).max() for axis in (right, up))
    camera = mi.ScalarTransform4f().look_at((centre + 3 * radius * observer).tolist(), centre.tolist(), up.tolist())
    camera = camera @ mi.ScalarTransform4f().scale([wide, high, 1])
    scene = mi.load_dict({
        "type": "scene", "integrator": {"type": "path", "max_depth": depth, "rr_depth": 1000}, **meshes,
        "sun": {"type": "directional", "direction": (-sun).tolist(), "irradiance": 1.0},
        "sensor": {"type": "orthographic", "to_world": camera, "near_clip": radius, "far_clip": 5 * radius,
                   "film": {"type": "hdrfilm", "width": PIXELS, "height": PIXELS, "rfilter": {"type": "box"},
                            "pixel_format": "luminance", "component_format": "float32"},
                   "sampler": {"type": "stratified", "sample_count": SAMPLES}}})
    return scene, 4 * wide * high / PIXELS**2


def ply_of(name, points):
    """A PLY file of triangles that share no vertices."""
    n = len(points)
    faces = np.zeros(n // 3, dtype=[("n", "u1"), ("v", "<i4", 3)])
    faces["n"], faces["v"] = 3, np.arange(n).reshape(-1, 3)
    path = os.path.join(sys.argv[1], name + ".ply")
    with open(path, "wb") as file:
        file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {n}\nproperty float x\nproperty float y\n"
                   f"property float z\nelement face {n // 3}\nproperty list uchar int vertex_indices\n"
                   "end_header\n".encode())
        file.write(points.astype("<f4").tobytes() + faces.tobytes())
    return path


def main(folder, out):
    with open(out, "w") as file:
        for path in glob.glob(os.path.join(folder, "instant-*.txt")):
            numbers = np.loadtxt(path)
            instant = int(os.path.basename(path)[8:-4])
            for name, (bsdf, depth) in CASES.items():
                scene, area = scene_of(numbers[2:, :3], numbers[2:, 3] > 0, numbers[0, :3], numbers[1, :3], bsdf, depth)
                values = [area * float(np.asarray(mi.render(scene, seed=17 + s), dtype=np.float64).sum())
                          for s in range(RUNS)]
                error = np.std(values, ddof=1) / np.sqrt(RUNS)
                for mesh in glob.glob(os.path.join(folder, "*.ply")):
                    os.unlink(mesh)
                print(name, instant, repr(float(np.mean(values))), repr(float(error)), file=file)


main(sys.argv[1], sys.argv[2])
