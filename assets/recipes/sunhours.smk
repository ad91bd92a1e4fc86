# Hours of sun in parts, for Snakemake, on one machine or on a cluster:
#
#     snakemake --cores 4 --snakefile sunhours.smk --config scene=town.glb parts=8 \
#         options="--place 48.14,11.57 --from 2026-01-01 --to 2026-12-31 --plan"
#
# makes sunhours/hours.png, sunhours/counts.png and sunhours/report.json, byte for byte those of
# one long run. `edgeshade`: the program, if it isn't on the path.
PROGRAM = config.get("edgeshade", "edgeshade")
PARTS = int(config.get("parts", 8))
FILES = expand("sunhours/{part}.part", part=range(1, PARTS + 1))

rule all:
    input: "sunhours/hours.png"

rule part:
    input: config["scene"]
    output: "sunhours/{part}.part"
    params: options=config["options"]
    shell: "{PROGRAM} sunhours {input:q} {output:q} {params.options} --part {wildcards.part}/{PARTS}"

rule merge:
    input: FILES
    output:
        picture="sunhours/hours.png",
        counts="sunhours/counts.png",
        report="sunhours/report.json",
    shell:
        "{PROGRAM} sunhours-merge {output.picture:q} {input:q} --counts {output.counts:q}"
        " --report {output.report:q}"
