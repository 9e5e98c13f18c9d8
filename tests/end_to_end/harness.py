# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the programs in a temporary folder of their own."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

IC, SPH, CASES = (os.path.abspath(sys.argv.pop(1)) for _ in range(3))


class Programs(unittest.TestCase):
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
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=300)
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
