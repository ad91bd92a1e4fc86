# The jobs of a city's plan, for Snakemake, on one machine or on a cluster:
#
#     edgeshade city plan tiles --date 2026-03-20 -o plan.json
#     snakemake --cores 4 --snakefile city.smk --config plan=plan.json map=map
#
# makes map/hours.tif and the other files of `city merge`. After a fault or a kill, run it again with
# --rerun-incomplete: it does what is missing. `edgeshade`: the program, if it isn't on the path.
import json

PROGRAM = config.get("edgeshade", "edgeshade")
PLAN = config["plan"]
MAP = config.get("map", "map")
with open(PLAN) as file:
    JOBS = json.load(file)["jobs"]

rule all:
    input: f"{MAP}/hours.tif"

rule job:
    input: PLAN
    output: f"{PLAN}.jobs/job-{{job}}.city"
    resources: mem_mb=lambda wildcards: JOBS[int(wildcards.job) - 1]["memory"] // 1000000
    shell: "{PROGRAM} city run {input:q} --job {wildcards.job}"

rule merge:
    input:
        plan=PLAN,
        results=expand(f"{PLAN}.jobs/job-{{job}}.city", job=range(1, len(JOBS) + 1)),
    output: f"{MAP}/hours.tif"
    params: map=MAP
    shell: "{PROGRAM} city merge {input.plan:q} -o {params.map:q}"
