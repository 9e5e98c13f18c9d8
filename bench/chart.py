#!/usr/bin/env python3
"""chart.py BENCH.json CHART.png: what a particle costs a step, against the number of particles, drawn
by gnuplot from what plenum-bench --json wrote."""
import json
import statistics
import subprocess
import sys

COLOURS = {("dam_break", 1): "#0b5394", ("dam_break", 2): "#6fa8dc",
           ("quiet_gas", 1): "#b45f06", ("quiet_gas", 2): "#f6b26b",
           ("ideal_gas", 1): "#38761d", ("ideal_gas", 2): "#93c47d"}
OTHER_COLOUR = "#666666"
SCENES = {"dam_break": "dam break", "quiet_gas": "quiet gas", "ideal_gas": "ideal gas"}


LEAST_SHARE_OF_CORES = 0.8  # as in bench/suite.hpp


def was_disturbed(run):
    """Whether other programs took the cores that the run's threads would have used."""
    threads = run["threads_used"]
    return threads > 1 and run["cores_used"] < LEAST_SHARE_OF_CORES * threads


def curves(runs):
    """{dimension: {(scene, precision, threads): {particles: [ns, ...]}}}, and how many measurements
    were left out."""
    left_out = 0
    found = {}
    for run in runs:
        if run.get("run_type") != "iteration" or "ns_per_particle" not in run:
            continue
        if was_disturbed(run):
            left_out += 1
            continue
        scene, dimension, precision = run["name"].split("/")[:3]
        curve = (scene, precision, int(run["threads_used"]))
        points = found.setdefault(int(dimension[0]), {}).setdefault(curve, {})
        points.setdefault(run["particles"], []).append(run["ns_per_particle"])
    return found, left_out


def order(curve):
    scene, precision, threads = curve
    return scene, precision != "mixed", threads


def panel(dimension, of_panel):
    """gnuplot's commands for one dimension: data blocks and a plot."""
    text, parts, points = "", [], []
    for k, curve in enumerate(sorted(of_panel, key=order)):
        scene, precision, threads = curve
        block = f"$d{dimension}_{k}"
        rows = sorted((n, statistics.median(ns)) for n, ns in of_panel[curve].items())
        text += f"{block} << EOD\n" + "".join(f"{n} {ns}\n" for n, ns in rows) + "EOD\n"
        points += rows
        colour = COLOURS.get((scene, threads), OTHER_COLOUR)
        style = "dt 1 pt 7" if precision == "mixed" else "dt 2 pt 6"
        title = f"{SCENES.get(scene, scene)}, {precision}, {threads} thread{'s' * (threads > 1)}"
        parts.append(f"{block} using 1:2 with linespoints lw 2 ps 1.1 lc rgb '{colour}' {style} "
                     f"title '{title}'")
    least, most = min(n for n, _ in points), max(n for n, _ in points)
    return (f"{text}set title '{dimension}-D'\n"
            f"set xrange [{0.7 * least}:{1.4 * most}]\n"
            f"set yrange [0:{1.1 * max(ns for _, ns in points)}]\n"
            f"set bmargin {5 + (len(parts) + 1) // 2}\n"
            f"plot {', '.join(parts)}\n")


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: chart.py BENCH.json CHART.png")
    with open(sys.argv[1], encoding="utf-8") as file:
        bench = json.load(file)
    panels, left_out = curves(bench["benchmarks"])
    if not panels:
        sys.exit(f"chart.py: {sys.argv[1]}: holds no measurement of an undisturbed step")
    note = f"; {left_out} measured on a busy machine left out" if left_out else ""
    script = f"""set terminal pngcairo size {100 + 620 * len(panels)},640 font 'DejaVu Sans,11'
set output '{sys.argv[2]}'
set multiplot layout 1,{len(panels)} title "Cost of a step, upkeep included \
({bench['context'].get('instruction_set', '')}){note}" font ',13'
set logscale x
set format x '10^{{%L}}'
set xlabel 'particles, walls included'
set ylabel 'time a particle and step [ns]'
set grid
set key below maxcols 2 samplen 2.5
"""
    script += "".join(panel(d, panels[d]) for d in sorted(panels)) + "unset multiplot\n"
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
