# SPDX-License-Identifier: GPL-3.0-or-later
"""run_all.py BUILD CASES OUT [--quick]: runs every case of a folder, one after the other, prints one
table and writes OUT/summary.json. `./run --all` calls it. A case that fails does not end the others;
the exit code is 2 then, or if a verdict is FAILED."""

import csv
import json
import pathlib
import statistics
import subprocess
import sys
import time

build, cases, out = (pathlib.Path(a) for a in sys.argv[1:4])
options = sys.argv[4:]


def drift(rows, column):
    """The largest difference from the first row."""
    values = [float(r[column]) for r in rows if r.get(column)]
    return max(abs(v - values[0]) for v in values) if values else None


def conservation(folder):
    """How energy and momentum went, from history.csv."""
    with open(folder / "history.csv") as f:
        rows = list(csv.DictReader(f))
    # Where gas comes in and leaves: without what it brought and took away.
    isOpen = "energy_balance [J]" in rows[0]
    energy, momentum_of = ("energy_balance", "momentum_balance_") if isOpen else ("energy_total", "momentum_")
    momentum = [drift(rows, f"{momentum_of}{a} [kg m/s]") for a in "xyz"]
    first, last = (float(rows[k][f"{energy} [J]"]) for k in (0, -1))
    return {"energy_first": first, "energy_last": last, "energy_drift": last - first,
            "momentum_drift": max(m for m in momentum if m is not None)}


def benchmarks():
    """Particles a second, walls included, of OUT/bench.json: of its smallest scenes with walls (dam_break)
    and without (quiet_gas), by dimension, precision and threads."""
    if not (out / "bench.json").exists():
        return {}
    with open(out / "bench.json") as f:
        lines = [line for line in json.load(f)["benchmarks"] if "particles" in line]
    smallest = min((line["particles"] for line in lines), default=0)
    rates = {}
    for line in lines:
        scene, dimension, precision = line["name"].split("/")[:3]
        if line["particles"] < 4 * smallest:
            key = (scene == "dam_break", int(dimension[0]), precision, line["threads"])
            rates.setdefault(key, []).append(1e6 * line["million_particles_per_second"])
    return {key: statistics.median(values) for key, values in rates.items()}


def of_benchmark(result):
    """Updates a second, walls included, over those of the benchmark like it; None if it was not run."""
    key = (result["wall_particles"] > 0, result["dimension"], result["precision"], result["threads"])
    particles = result["fluid_particles"] + result["wall_particles"]
    rate = result["updates_per_second"] * particles / result["fluid_particles"]
    return rate / rates[key] if key in rates else None


def run(case):
    """What a case came to, and what it printed if it failed."""
    name, folder = case.stem, out / case.stem
    folder.mkdir(parents=True, exist_ok=True)
    particles = folder / f"{name}.hdf"
    start = time.time()
    for command in ([build / "ictools/plenum-ic", "generate", case, "-q", "--no-report", "-o",
                     particles, *options],
                    [build / "solver/plenum-sph", "run", particles, "-q", "--anew", "-o", folder]):
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            return {"case": name, "error": (done.stderr or done.stdout).strip()}
    result = {"case": name, "seconds": time.time() - start}
    with open(folder / "summary.json") as f:
        result.update(json.load(f))
    result["case"] = name
    result["conservation"] = conservation(folder)
    result["of_benchmark"] = of_benchmark(result)
    verdicts = []
    if (folder / "validation.json").exists():
        with open(folder / "validation.json") as f:
            verdicts = json.load(f)
    result["validation"] = verdicts
    return result


def row(result):
    """A line of the table."""
    if "error" in result:
        return f"{result['case']:<24} did not run: {result['error']}"
    count = {}
    for v in result["validation"]:
        count[v["verdict"]] = count.get(v["verdict"], 0) + 1
    kept = result["conservation"]
    share = "-" if result["of_benchmark"] is None else f"{100 * result['of_benchmark']:.0f} %"
    return (f"{result['case']:<24}{result['dimension']:>3}{result['fluid_particles']:>9}"
            f"{result['wall_particles']:>8}{result['steps']:>8}{result['seconds']:>9.1f}"
            f"{result['updates_per_second'] / 1e6:>11.2f}{share:>9}{result['bytes_per_particle']:>7.0f}"
            f"{kept['energy_first']:>11.4g}{kept['energy_drift']:>11.2g}"
            f"{kept['momentum_drift']:>11.1g}"
            f"   {', '.join(f'{n} {v}' for v, n in sorted(count.items())) or '-'}")


print(f"{'case':<24}{'dim':>3}{'fluid':>9}{'walls':>8}{'steps':>8}{'time [s]':>9}{'M updates/s':>12}"
      f"{'of bench':>9}{'bytes':>7}{'energy [J]':>11}{'drift':>11}{'momentum':>11}   verdicts")
rates = benchmarks()
results = []
for path in sorted(cases.glob("*.toml")):
    results.append(run(path))
    print(row(results[-1]), flush=True)
failed = [r for r in results
          if "error" in r or any(v["verdict"] == "FAILED" for v in r["validation"])]
for r in failed:
    for v in r.get("validation", []):
        if v["verdict"] == "FAILED":
            print(f"{r['case']}: FAILED: {json.dumps(v)}")
with open(out / "summary.json", "w") as f:
    json.dump(results, f, indent=2)
print(f"M updates/s: fluid particles that steps move on a second, without measures and files; of bench: "
      f"with\nwalls, over the like scene of ./run --bench (-: not run); bytes: a particle, neighbour list "
      f"included;\ndrift, momentum: the largest change of total energy [J] and of momentum [kg m/s]; "
      f"all of it: {out / 'summary.json'}")
sys.exit(2 if failed else 0)
