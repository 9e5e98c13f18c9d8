# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables and charts of what tests measure. Tables are printed; with PLENUM_FIGURES=FOLDER in the
environment (`./run --figures`) they and the charts are written there."""

import os
import subprocess

FOLDER = os.environ.get("PLENUM_FIGURES")
if FOLDER:
    FOLDER = os.path.abspath(FOLDER)
COLOURS = ("#0b5394", "#b45f06", "#38761d", "#741b47", "#666666", "#20a4b8")


def table(name, rows):
    """Rows of texts or numbers, the first one the heads; as wide as what stands in them."""
    texts = [[cell if isinstance(cell, str) else f"{cell:.4g}" for cell in row] for row in rows]
    widths = [max(len(row[k]) for row in texts) for k in range(len(texts[0]))]
    lines = ["  ".join(cell.ljust(w) if k == 0 else cell.rjust(w)
                       for k, (cell, w) in enumerate(zip(row, widths))).rstrip()
             for row in texts]
    text = "\n".join(lines) + "\n"
    print(f"\n{text}", flush=True)
    if FOLDER:
        with open(os.path.join(FOLDER, name + ".txt"), "w") as file:
            file.write(text)


def chart(name, title, axes, curves, *commands, size="760,580"):
    """Curves {title: [(x, y), ...]} as a PNG, drawn by gnuplot; `axes` names x and y."""
    if not FOLDER:
        return
    blocks, parts = "", []
    for k, (label, points) in enumerate(curves.items()):
        blocks += f"$c{k} << EOD\n" + "".join(f"{x} {y}\n" for x, y in points) + "EOD\n"
        parts.append(f"$c{k} using 1:2 with linespoints lw 2 pt 7 ps .6 "
                     f"lc rgb '{COLOURS[k % len(COLOURS)]}' title \"{label}\"")
    script = (f"set terminal pngcairo size {size} font 'DejaVu Sans,11' noenhanced\n"
              f"set output '{os.path.join(FOLDER, name + '.png')}'\n"
              f"set title \"{title}\"\nset xlabel \"{axes[0]}\"\nset ylabel \"{axes[1]}\"\n"
              "set grid lc rgb '#dddddd' lt 1\nset key below maxcols 1\n"
              f"set bmargin {5 + len(curves)}\n"
              + "".join(command + "\n" for command in commands)
              + blocks + f"plot {', '.join(parts)}\n")
    subprocess.run(["gnuplot"], input=script, text=True, check=True)
