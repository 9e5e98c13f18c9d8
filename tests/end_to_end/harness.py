# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the programs in a temporary folder of their own."""

import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

IC, SPH, CASES = (os.path.abspath(sys.argv.pop(1)) for _ in range(3))


class Programs(unittest.TestCase):
    patience = 300  # seconds that a program may take

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="plenum")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, name, text):
        with open(self.path(name), "w") as f:
            f.write(text)
        return self.path(name)

    def start(self, *command):
        """(exit code, stdout, stderr)"""
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True,
                              timeout=self.patience)
        return done.returncode, done.stdout, done.stderr

    def ok(self, *command):
        code, out, err = self.start(*command)
        self.assertEqual(code, 0, f"{command}\n{out}\n{err}")
        return out

    def refused(self, command, *expected, code=1):
        """The command must fail with `code` and one line on stderr that holds all of `expected`."""
        actual, _, err = self.start(*command)
        self.assertEqual(actual, code, err)
        lines = [line for line in err.splitlines()
                 if not line.startswith("run:") and "warning:" not in line]
        self.assertEqual(len(lines), 1, f"one line, please:\n{err}")
        for text in expected:
            self.assertIn(text, lines[0])
        return lines[0]

    def run_case(self, name, *sets, without=(), edit=None):
        """(summary, columns of history.csv) of a case with some keys set, some lines left out and its
        text changed by edit(text)."""
        with open(f"{CASES}/{name}.toml") as file:
            text = file.read()
        for key in without:
            text, n = re.subn(rf"^{key}\s.*\n", "", text, flags=re.M)
            self.assertEqual(n, 1, key)
        case = self.write(f"{name}.toml", edit(text) if edit else text)
        self.ok(IC, "generate", case, "-q", "--no-report", "-o", "set.hdf",
                *(word for value in sets for word in ("--set", value)))
        self.ok(SPH, "run", "set.hdf", "-q", "--anew", "-o", "out")
        with open(self.path("out", "summary.json")) as file:
            summary = json.load(file)
        with open(self.path("out", "history.csv")) as file:
            head, *rows = (line.strip().split(",") for line in file)
        heads = [cell.split(" [")[0] for cell in head]
        columns = {name: [float(row[k]) if row[k] else math.nan for row in rows]
                   for k, name in enumerate(heads)}
        return summary, columns
