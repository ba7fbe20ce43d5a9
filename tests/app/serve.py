"""umbra serve answers its own page alone, and computes what umbra run computes.

   serve.py UMBRA SCENARIO FOLDER     FOLDER: made anew for a run, taken away
"""
import csv
import json
import re
import shutil
import signal
import subprocess
import sys
import urllib.error
import urllib.request

umbra, scenario, folder = sys.argv[1:]
FACTOR = 1.5
EFFECT = "emittance:mli"


def ask(url, body=None, headers=None):
    """Status and text of an answer."""
    request = urllib.request.Request(url, data=body, headers=headers or {})
    try:
        with urllib.request.urlopen(request, timeout=120) as answer:
            return answer.status, answer.read().decode()
    except urllib.error.HTTPError as error:
        return error.code, error.read().decode()


def check(what, holds):
    if not holds:
        raise SystemExit(f"{what}: failed")
    print(f"{what}: ok")


server = subprocess.Popen([umbra, "serve", scenario, "--only", EFFECT], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True)
try:
    url = re.search(r"http://127\.0\.0\.1:\d+/\?token=\w{32}", server.stdout.readline()).group()
    home, token = url.split("/?token=")
    bearer = {"Authorization": f"Bearer {token}"}
    status, page = ask(url)
    check("the page comes with its token", status == 200 and "umbra-document" in page)
    name = re.search(r'"name": "(emittance:mli\.[a-z_]+)"', page).group(1)
    check("not without it", ask(home + "/")[0] == 403)
    check("nor with another", ask(f"{home}/?token={token[::-1]}")[0] == 403)
    check("nor as another host", ask(url, headers={"Host": "example.org"})[0] == 403)
    body = json.dumps({"values": {name: FACTOR}}).encode()
    check("nothing is computed without the token", ask(home + "/compute", body)[0] == 403)
    check("nor for another page", ask(home + "/compute", body, bearer | {"Origin": "http://example.org"})[0] == 403)
    check("a body too long is refused", ask(home + "/compute", b" " * 70000, bearer)[0] == 413)
    status, text = ask(home + "/compute", json.dumps({"values": {"emitance": 1}}).encode(), bearer)
    check("a wrong name is told", status == 400 and "emitance" in text)
    status, text = ask(home + "/compute", json.dumps({"values": {name: 100}}).encode(), bearer)
    check("a value out of range is told", status == 400 and "accepted: from 0.1 to 10" in text)
    status, text = ask(home + "/compute", body, bearer)
    curves = {c["name"]: c["data"] for c in json.loads(text)["curves"]}
    subprocess.run([umbra, "run", scenario, "--with", f"{EFFECT},{name.split('.')[1]}={FACTOR}", "--out", folder,
                    "--no-plots"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open(f"{folder}/lightcurve.csv", newline="") as file:
        run = [float(row["lwir_irradiance_W_m2"]) for row in csv.DictReader(file)]
    largest = max(abs(a - b) for a, b in zip(run, curves["lwir"], strict=True)) / max(run)
    print(f"lwir by the server and by umbra run: {largest:.1e} of the largest")
    check("what is computed is what umbra run computes", largest < 1e-3)
finally:
    server.send_signal(signal.SIGTERM)
    code = server.wait(timeout=10)
    shutil.rmtree(folder, ignore_errors=True)
check("a signal ends it", code in (0, 143))
