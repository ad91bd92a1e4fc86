#!/usr/bin/env python3
"""job_memory_test.py EDGESHADE MAKE_CITY: jobs with wide halos keep to the memory that the plan says, even without the
plan's room for the program itself, which is as much as a job of a single block takes."""

import json
import os
import subprocess
import sys
import tempfile

edgeshade, make_city = sys.argv[1:]


def jobs_of(name, *words):
    """Plans a city that make_city draws by the words; returns its jobs."""
    subprocess.run([make_city, name, *words], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([edgeshade, "city", "plan", name, "--place", "48.14,11.57", "--date", "2026-03-20", "--step", "240",
                    "--min-altitude", "3", "--grid", "32", "--tiles", "4", "-o", f"{name}.json"], check=True,
                   stderr=subprocess.DEVNULL)
    return json.load(open(f"{name}.json"))["jobs"]


def bytes_of(name, job):
    """The most memory that the job's process takes."""
    process = subprocess.Popen([edgeshade, "city", "run", f"{name}.json", "--job", str(job)],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 0, (name, job)
    return 1024 * usage.ru_maxrss


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    (block, *_) = jobs_of("block", "gltf", "1", "1", "1", "0", "1")
    program = bytes_of("block", 1)
    for number, job in enumerate(jobs_of("city", "gltf", "1", "6", "8", "200", "64")[:2], 1):
        used, planned = bytes_of("city", number) - program, job["memory"] - block["memory"]
        print(f"job {number}: {used:,} of {planned:,} bytes, and {program:,} for the program")
        assert used <= planned
