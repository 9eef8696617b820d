"""A build backend of its own (PEP 517), because it needs no download: CMake builds, and a wheel is a zip file.

OXTURN_BUILD_DIR in the environment names a build folder to take the module from; otherwise build/wheel is made.
"""
import base64
import glob
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import zipfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def version():
    with open(os.path.join(ROOT, "CMakeLists.txt")) as file:
        return re.search(r"project\(oxturn VERSION ([0-9.]+)", file.read()).group(1)


def build():
    folder = os.environ.get("OXTURN_BUILD_DIR")
    if not folder:
        folder = os.path.join(ROOT, "build", "wheel")
        subprocess.check_call(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                               "-DOXTURN_TESTS=OFF", "-DOXTURN_BENCHMARKS=OFF",
                               "-DPython_EXECUTABLE=" + sys.executable])
        subprocess.check_call(["cmake", "--build", folder, "--target", "oxturn_python"])
    return folder


def contents(folder):
    """Names in the wheel, and the files that they come from. The module looks for the library beside itself."""
    files = {"oxturn/" + os.path.basename(f): f for f in glob.glob(os.path.join(folder, "python/oxturn/*"))
             if os.path.isfile(f)}
    library = glob.glob(os.path.join(folder, "liboxturn.so.*.*.*"))
    if not library or not any(name.startswith("oxturn/_oxturn") for name in files):
        sys.exit("python/backend.py: %s has no Python module; build it with -DOXTURN_PYTHON=ON" % folder)
    soname = ".".join(os.path.basename(library[0]).split(".")[:4])
    files["oxturn/" + soname] = library[0]
    return files


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    python = "cp%d%d" % sys.version_info[:2]
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    name = "oxturn-%s-%s-%s-%s.whl" % (version(), python, python, platform)
    info = "oxturn-%s.dist-info/" % version()
    metadata = ("Metadata-Version: 2.1\nName: oxturn\nVersion: %s\n"
                "Summary: the coverage-path-planning zoo and benchmark\nRequires-Dist: numpy\n" % version())
    wheel = ("Wheel-Version: 1.0\nGenerator: oxturn\nRoot-Is-Purelib: false\n"
             "Tag: %s-%s-%s\n" % (python, python, platform))
    record = ""
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as archive:
        entries = {inside: open(file, "rb").read() for inside, file in sorted(contents(build()).items())}
        entries.update({info + "METADATA": metadata.encode(), info + "WHEEL": wheel.encode()})
        for inside, data in entries.items():
            archive.writestr(inside, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record += "%s,sha256=%s,%d\n" % (inside, digest, len(data))
        archive.writestr(info + "RECORD", record + info + "RECORD,,\n")
    return name
