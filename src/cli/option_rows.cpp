#include "preprocess/packing/shadow_extension.hpp"
#include "preprocess/scene/animation.hpp"
#include "preprocess/scene/instance_choice.hpp"
#include "preprocess/volumes/shadow_data.hpp"
#include "src/cli/option_table.hpp"
#include "src/hours/preset.hpp"
#include "src/settings/settings.hpp"

// A namespace of its own: names of verbs and groups are short.
namespace edgeshade::cli::rows {
namespace {

// Verbs, in the order of verbNames, and those that draw, have lights, show a scene, read a file.
constexpr Verbs pack = 1, info = 2, render = 4, compare = 8, bench = 16, tradeoff = 32,
                sunhours = 64, merge = 128, view = 256, cityPlan = 512, cityRun = 1024,
                cityMerge = 2048;
constexpr Verbs draws = render | compare | bench | view, lit = draws | tradeoff,
                sees = lit | sunhours, reads = sees | pack | info,
                cities = cityPlan | cityRun | cityMerge, all = reads | merge | cities;

Where usual(Verbs verbs) {
    return {verbs, verbs};
}

constexpr double infinite = Interval().high;

Values words(std::vector<std::string> words) {
    return {std::move(words)};
}
Values whole(double low, double high) {
    return {{}, Interval{.low = low, .high = high, .isWhole = true}};
}
constexpr double mostLimit = 1e18;
Values bytes() {
    return {{}, Interval{.low = 1, .high = mostLimit, .isWhole = true, .isBytes = true}};
}
Values from(double low, double high = infinite) {
    return {{}, Interval{.low = low, .high = high}};
}
Values above(double low, double high = infinite) {
    return {{}, Interval{.low = low, .high = high, .isAbove = true}};
}
Values below(Values values) {
    values.interval->isBelow = true;
    return values;
}
Values autoOr(Values values) {
    values.words = {"auto"};
    return values;
}
Values presets() {
    Values values;
    for (const hours::Preset& preset : hours::presets())
        values.words.emplace_back(preset.name);
    return values;
}

/// The option of a setting of drawing.
template <class Domain>
Option of(const Setting<Domain>& setting, const char* type, const char* initial,
          const char* sentence, const char* more = "", Where where = draws) {
    Option option(optionNameOf(setting.key) + " " + type, valuesOf(setting.domain), initial, where,
                  sentence, more);
    option.needs = optionsFor(setting.needs);
    return option;
}

const std::vector<Option> picture = {
    {"--size WxH", "=1920x1080", usual(sees & ~view), "Size of the picture in pixels"},
    {"--size WxH", "=1280x720", usual(view), "Size of the window in pixels"},
    {"--camera NAME|INDEX", "", Where(sees, render | compare | view),
     "A camera of the file; `edgeshade info` lists them",
     "NAME is its own or its node's. INDEX counts the cameras that nodes place, from 0."},
    {"--camera-from X,Y,Z", "where it sees the whole scene",
     Where(sees, render | compare | view | sunhours), "Position of the eye"},
    {"--camera-to X,Y,Z", "the middle of the scene",
     Where(sees, render | compare | view | sunhours), "Point that the eye looks at"},
    {"--camera-matrix M0,...,M15", "", sees, "View matrix, world to camera, column by column",
     "It replaces these two points."},
    {"--fov DEG", below(above(0.0, 180.0)), "=45", Where(sees, render | view),
     "Vertical field of view in degrees"},
    {"--ortho HEIGHT", above(0.0), "in perspective", sees,
     "Orthographic picture of this height, in scene units"},
    {"--near D", autoOr(above(0.0)), "=auto", sees, "Distance of the near plane, in scene units",
     "auto: as far out as the visible geometry allows."},
    {"--plan", usual(sunhours), "Show the whole scene from straight above, north up"},
    {"--mask", usual(render), "Draw what the first light reaches: white lit, black in shadow",
     "Grey is the visible share of a light with an extent. Pixels without a surface are clear."},
    {"--smooth N", valuesOf(settings::smooth.domain), "=1", usual(render | view),
     "Number of pictures averaged, for smooth edges and shadows",
     "Each samples another place within the pixels. The window averages them at rest."},
    {"--samples N", whole(0, 64), "=0", render | bench | view,
     "Samples per pixel, for antialiasing", "0: none."},
    {"--ground KIND", "off", Where(sees, render | view),
     "Plane beneath the scene: off, catcher or a colour #RRGGBB",
     "catcher shows only shadow; it is the default of view if the scene has no floor."},
    {"--variant NAME", "the scene's own materials", sees,
     "A variant of the materials; `edgeshade info` lists them"},
    {"--time S", from(0.0, longestTime), "at rest; 0 in view or with --animation",
     Where(sees, render), "Time of the animation, in seconds"},
    {"--animation NAME|INDEX", "the first", sees,
     "An animation of the file; `edgeshade info` lists them"},
    {"--cull WORD", valuesOf(settings::cull.domain),
     "auto; off with --layout published or brute-force", sees,
     "Whether materials that aren't double-sided are invisible from behind",
     "Both sides cast shadows either way."},
    {"--section NX,NY,NZ,D", "", Where(sees, render | compare | view),
     "Cut the scene open along a plane; may be repeated",
     "It keeps the points where NX*x + NY*y + NZ*z + D is 0 or more, for at most 6 planes. The "
     "ground isn't cut."},
    {"--section-box X0,Y0,Z0,X1,Y1,Z1", "", sees, "Cut the scene open: keep this box"},
    {"--section-shadows WORD", valuesOf(settings::sectionShadows.domain), "=cut", sees,
     "Whether what is cut away casts shadows",
     "cut: it does not. whole: it casts as built, so that rooms keep their light."},
    {"--section-fill COLOUR", "=#cc5540", sees,
     "Colour of cut faces of solids, #RRGGBB, or none to leave them open"},
    {"--screenshot OUT.png", "", usual(view), "Save one picture and close the window"}};

const std::vector<Option> lights = {
    {"--sun X,Y,Z", "", usual(lit),
     "A directional light, by the direction towards it; may be repeated",
     "X,Y,Z:#RRGGBB:LUX adds a colour and perhaps an intensity."},
    {"--light X,Y,Z", "the file's, or a sun", usual(lit),
     "A point light, by its position; may be repeated",
     "X,Y,Z:#RRGGBB:CANDELA adds a colour and perhaps an intensity."},
    {"--lights WORD", words({"file", "default"}), "file", lit, "Lights if no option names one",
     "file: the file's, or a sun from above if it has none. default: that sun. bench also takes "
     "N,N,...: so many point lights scattered over the scene, measured one after the other."},
    {"--light-range R", above(0.0), "unlimited", lit,
     "Distance at which point lights end, in scene units"},
    {"--light-radius R", above(0.0), "points", Where(lit, draws),
     "Radius of point lights, in scene units, for soft shadows"},
    {"--light-size W,H", "points", lit,
     "Width and height of point lights as rectangles, in scene units, for soft shadows",
     "They shine to one side."},
    {"--light-direction X,Y,Z", "down", lit, "Direction that rectangles shine in",
     "Their width is horizontal."},
    {"--sun-angle DEG", above(0.0, 90.0), "one direction", Where(lit, render | compare | view),
     "Angular diameter of suns in degrees, for soft shadows", "The real sun's is 0.53."},
    of(settings::lightSamples, "N", "=64", "Number of points per light with an extent",
       "The shadow of each is exact."),
    {"--shade-samples", render,
     "Shade by every point of a light with an extent, not by its centre"},
    of(settings::shadowedLights, "N", "=all", "Number of lights with shadows",
       "They are estimated to add most to the picture. The others shine through everything."),
    {"--place LAT,LON", "", Where(lit, render | view),
     "Place for a sun by place and time: degrees north and east",
     "It is the first light. Below the horizon it lights nothing."},
    {"--place LAT,LON", "", usual(sunhours), "Place of the scene: degrees north and east"},
    {"--place LAT,LON|auto", "=auto", usual(cityPlan), "Place of the city: degrees north and east",
     "auto: by the tiles' EPSG code or the earth-centred axes of 3D Tiles, with true north."},
    {"--time-of-day TIME", "", Where(lit, render | view),
     "Time for that sun, for example 2026-06-21T14:30+02:00",
     "It has the clock's offset from UTC; years are 1900 to 2100."},
    {"--north DEG", from(-360.0, 360.0), "=0", Where(lit | sunhours, view | sunhours),
     "Direction of north, in degrees clockwise from -Z, seen from above"},
    {"--north DEG", from(-360.0, 360.0), "=0", cityPlan,
     "Direction of north, in degrees clockwise from the coordinates' own north",
     "With --place auto the coordinate system says it."}};

constexpr const char* methods =
    "volumes: counted in the stencil. lookup (or primitive-map): exact lookups for lights at rest. "
    "points (or irregular-z-buffer): the processor tests every visible point. auto: lookup, points "
    "or volumes for each light, whichever costs least. map: shadow maps. planar: projected onto "
    "the largest planes alone.";

const std::vector<Option> shadows = {
    of(settings::shadows, "METHOD", "=volumes", "Shadow method", methods, usual(draws & ~view)),
    of(settings::shadows, "METHOD", "=auto", "Shadow method", methods, usual(view)),
    {"--cast-cutouts", Where(sees, render | compare | view),
     "MASK materials cast the shadow of what their alpha leaves",
     "lookup draws it exactly, and map does too. volumes and points leave it out."},
    {"--cast-masked", Where(reads, pack),
     "MASK and BLEND materials cast shadows of whole triangles"},
    of(settings::maskScale, "SHARE", "=1", "Resolution at which volumes are counted",
       "It is a share of the picture's; less is faster and less exact."),
    of(settings::primitiveMapMemory, "BYTES", "=134217728",
       "GPU memory of all primitive maps, in bytes",
       "If a light's map doesn't fit, a coarser one is tried, and then volumes.")};

const std::vector<Option> materials = {
    of(settings::shading, "WORD", "=full", "Shading of surfaces",
       "full: everything that materials define. base: base colour and Lambert's law."),
    of(settings::ambient, "SHARE", "0.45; 0.35 with --shading base",
       "Share of ambient light in display values", "The lights share the rest."),
    of(settings::environment, "FILE.hdr", "=neutral",
       "Radiance picture of the surroundings, for ambient light",
       "It is equirectangular, with -Z in its middle. Its mean brightness becomes --ambient. "
       "neutral: a grey sky and ground.",
       Where(draws, render | view)),
    of(settings::exposure, "EV", "=0", "Multiply the light by 2^EV", "",
       Where(draws, render | view)),
    of(settings::terminator, "WORD", "=exact", "Shading of smooth surfaces at grazing light",
       "soft: dimmed until their facets turn away. exact: as bright as normals say.")};

const std::vector<Option> meshes = {
    {"--encoding KIND",
     words({nameOf(Encoding::none), nameOf(Encoding::indexed), nameOf(Encoding::expanded)}),
     "=none", usual(pack), "Edges in the file",
     "none: they are found at load, which is as quick. indexed or expanded: records for --layout "
     "published, the latter ready for the GPU."},
    {"--weld-tolerance D", autoOr(from(0.0)), "0", Where(reads, pack | info),
     "Join vertices closer than this, in scene units",
     "auto: as much as closes most borders, up to 0.01 % of the scene's diagonal."},
    {"--flat-tolerance DEG", below(from(0.0, flatToleranceEnd)), "0", Where(reads, pack),
     "Edges that bend no more than this cast nothing, in degrees", "0: exactly flat ones."},
    {"--caster-error D", from(0.0), "0", Where(reads, pack),
     "Simplify casters by about this distance, in scene units",
     "Visible surfaces stay as they are."},
    {"--instances WORD",
     words({nameOf(InstanceChoice::automatic), nameOf(InstanceChoice::shared),
            nameOf(InstanceChoice::repeated)}),
     "auto", Where(reads, pack), "Storage of repeated meshes",
     "shared: once. repeated: again for each place. auto: once where that pays."}};

const std::vector<Option> sunlight = {
    {"--date DATE", "", usual(sunhours | cityPlan), "The day, for example 2026-03-21"},
    {"--from DATE", "", usual(sunhours | cityPlan), "First of several days"},
    {"--to DATE", "", usual(sunhours | cityPlan), "Last of several days"},
    {"--step MIN", whole(1, 1440), "=10", Where(sunhours | view | cityPlan, sunhours | cityPlan),
     "Minutes that each sun position stands for",
     "They divide the hours that count; positions are in their middle."},
    {"--hours A-B", "0-24", usual(sunhours),
     "Hours of the clock that count, for example 9-17 or 9:30-17"},
    {"--utc-offset +HH:MM", "whole hours, by longitude", usual(sunhours | cityPlan),
     "The clock's offset from UTC, with summer time"},
    {"--min-altitude DEG", from(0.0, 90.0), "0; 6 with a preset of DIN 5034-1", sunhours,
     "Altitude from which the sun counts, in degrees"},
    {"--min-altitude DEG", from(0.0, 90.0), "=5", usual(cityPlan),
     "Altitude from which the sun counts, in degrees",
     "A lower one takes a wider halo of tiles around each target."},
    {"--threshold H", from(0.0, 24.0), "", usual(sunhours),
     "Report the area that gets at least so many hours per day"},
    {"--preset NAME", presets(), "", usual(sunhours), "Threshold and date of a recommendation",
     "EN 17037: 1.5, 3 or 4 hours. BRE 209: two hours on half of a garden. DIN 5034-1: an hour on "
     "17 January, 4 hours at the equinox. The default date is 21 March " +
         std::to_string(static_cast<int>(hours::presetYear)) + ", or that of winter."},
    {"--at X,Y,Z", "", usual(sunhours), "Report the hours at this point; may be repeated",
     "X,Y,Z,NX,NY,NZ adds the direction that it faces."},
    {"--by WORD", words({"auto", "rays", "masks"}), "=auto", usual(sunhours),
     "What counts the sun positions",
     "rays: rays without rounding, on all cores. masks: exact shadow masks that the GL draws. "
     "auto: "
     "rays where the processor draws, masks where hardware does."},
    {"--surfaces", usual(sunhours),
     "Measure every surface, whether a camera sees it or not, in cells of a grid",
     "OUT is one or more files. .glb: the cells as a coloured mesh. .csv: a table of cells. .npy: "
     "a packed bit for each cell and sun position."},
    {"--grid D", above(0.0), "=0.5", usual(sunhours), "Greatest width of a cell, in metres"},
    {"--grid D", from(0.01, 100.0), "=1", usual(cityPlan), "Width of a cell, in metres"},
    {"--lod N", from(0.0, 10.0), "the highest", usual(cityPlan),
     "Greatest level of detail of CityJSON, for example 2.2",
     "Each object has the highest that isn't above it."},
    {"--memory BYTES", bytes(), "=4G", usual(cityPlan), "Memory that a job may take, by estimate",
     "Targets are divided until they fit. K, M and G are powers of 1024."},
    {"--tiles N", whole(1, 1000000), "=1", usual(cityPlan), "Least number of targets",
     "Targets are squares of a power of two of cells, at least 16."},
    {"--months", usual(cityPlan), "Count by month too, into months.tif",
     "A GeoTIFF of twelve bands, on the plan's clock."},
    {"--bits", usual(cityPlan), "Keep which sun positions light each cell, in bits.npy",
     "Bytes by row, column and packed position."},
    {"--job K", whole(1, 1e9), "", usual(cityRun), "Number of the job, from 1"},
    {"-o,--output FILE", "", usual(cityPlan), "The plan to write, .json"},
    {"-o,--output FOLDER", "PLAN.jobs", usual(cityRun), "Folder of results"},
    {"-o,--output FOLDER", "", usual(cityMerge),
     "Folder to write hours.tif, objects.csv, preview.png and report.json into",
     "CityJSON sources come with the hours of their objects, as hours-NAME."},
    {"--offset D", from(0.0), "=0", sunhours, "Distance of sensors from their surfaces, in metres",
     "0: on them, where a surface's own plane blocks nothing."},
    {"--unit M", above(0.0), "=1", sunhours, "Metres that a scene unit is"},
    {"--nodes NAME", "all", sunhours, "Measure the surfaces of this node; may be repeated",
     "Those of nodes beneath it belong to it."},
    {"--materials NAME", "all", sunhours, "Measure the surfaces of this material; may be repeated"},
    {"--windows NAME", "", usual(sunhours),
     "Measure the middles of windows, by their node or material; may be repeated",
     "With a preset or --threshold the report says which of them pass. EN 17037 takes a lower "
     "point, "
     "0.3 m over the pane's lower edge."},
    {"--sill H", from(0.0), "", sunhours, "Metres from the floor to the panes' lower edges",
     "With a preset of EN 17037 sensors are 1.2 m over the floor then, where that is higher."},
    {"--epw FILE", "", usual(sunhours),
     "Weather file of EnergyPlus: place, time zone and direct normal radiation"},
    {"--quantity WORD", words({"hours", "direct-kwh"}), "=hours", sunhours,
     "Quantity that surfaces are coloured and reported by",
     "direct-kwh: kWh/m² of the direct beam by the weather file of --epw; no light of the sky."},
    {"--when", sunhours | merge, "Add the first and the last time of sun to tables"},
    {"--counts OUT.png", "", Where(sunhours | merge, merge),
     "Picture of counted sun positions, 16-bit grey", "Pixels without a surface are clear."},
    {"--part K/N", "", sunhours, "Count every N-th position from the K-th on, for sunhours-merge"},
    {"--sun-hours", usual(view), "Show the hours of sunlight on the day of --time-of-day"}};

const std::vector<Option> measuring = {
    {"--views N", whole(1, 1000), "=16", usual(compare | tradeoff),
     "Number of views to judge, around and inside the scene",
     "A camera option replaces them with its own view."},
    {"--frames N", whole(1, 100000), "120; 9 turns with --synthetic", usual(bench),
     "Number of frames to time",
     "The camera flies through the scene, or stays where a camera option puts it."},
    {"--frames N", whole(1, 100000), "=40", usual(tradeoff), "Number of frames to time",
     "Settings that are clearly worse get fewer frames and views, unless a number is typed."},
    {"--against SETTING", "", usual(compare | bench | tradeoff),
     "Measure this setting too, NAME=VALUE,...; may be repeated",
     "For example shadows=map,map-size=2048 or caster-error=0.01. bench takes turns frame by "
     "frame. compare tunes the bias of maps, unless map-bias is given."},
    {"--heatmap OUT.png", "", usual(compare), "Picture of the wrong pixels in the worst view",
     "Red is wrongly lit, blue wrongly dark, green otherwise wrong, yellow a tie."},
    {"--plot OUT", "", usual(tradeoff), "Plot of time against wrong pixels, .svg or .png"},
    {"--budget-ms MS", above(0.0), "", usual(tradeoff),
     "Find the most accurate setting within this time of a frame"},
    {"--max-wrong-percent P", from(0.0, 100.0), "", usual(tradeoff),
     "Find the fastest setting with no more wrong pixels than this", "In percent of visible ones."},
    {"--time-limit SECONDS", above(0.0), "=240", usual(tradeoff),
     "Seconds that measuring may take"},
    {"--largest-map N", whole(512, 8192), "=8192", usual(tradeoff),
     "Largest shadow map to try, in texels", "A cube of 8192 takes 1.9 GB."},
    {"--warm-up N", whole(0, 1000), "=3", usual(bench), "Number of frames to draw before timing"},
    {"--light-moves", usual(bench | tradeoff),
     "Move the lights in small circles, so that maps are drawn in every frame"},
    {"--light-circle DEG", from(1e-6, 10.0), "=3", usual(bench),
     "Radius of these circles, in degrees for suns",
     "For lamps in 150ths of the scene's diagonal."},
    {"--sizes WxH,...", "", usual(bench), "Several picture sizes, or all for four common ones",
     "all: 800x600, 1920x1080, 2560x1600 and 3840x2160."},
    {"--timing CLOCK", words({"query", "finish", "processor"}), "query, else finish",
     usual(bench | tradeoff), "Clock of frame times",
     "query: the GPU's timer queries. finish: the wall clock, waiting for the GPU. processor: the "
     "processor's time on all cores, for a software GL on a busy machine."},
    {"--explain", render,
     "Say what is drawn of the shadow volumes, how and why, and what is left out"},
    {"--report FILE", "", usual(all & ~(view | sunhours | merge | cities)),
     "Write a JSON report; - is standard output"},
    {"--report FILE", "", usual(sunhours | merge),
     "Write a JSON report, or of --surfaces a page, .html; - is standard output",
     "A page has pictures, a table and all settings, for screen and paper."}};

const std::vector<Option> limits = {
    {"--max-file BYTES", bytes(), "=4G", reads,
     "Refuse larger files: the scene's own, and those that it names",
     "K, M and G are powers of 1024."},
    {"--max-memory BYTES", bytes(), sizeof(void*) == 8 ? "=16G" : "=2G", reads,
     "Refuse scenes that need more memory while they are read",
     "Files, JSON, decompressed data, images and vertices count."},
    {"--max-triangles N", whole(1, mostLimit), "=50000000", reads,
     "Refuse scenes of more triangles", "A mesh counts once for each node that uses it."},
    {"--max-nodes N", whole(1, mostLimit), "=2000000", reads, "Refuse scenes of more nodes"},
    {"--max-node-depth N", whole(1, mostLimit), "=1000", reads,
     "Refuse scenes of more levels of nodes"}};

const std::vector<Option> maps = {
    of(settings::mapSize, "N", "=2048", "Width of a shadow map in texels",
       "Point lights have six."),
    of(settings::mapBias, "TEXELS", "=1.5",
       "Distance that receivers are moved towards the light, in texels"),
    of(settings::mapKind, "KIND", "=cube", "Kind of shadow map",
       "cube: six faces around a lamp, one map for a sun. cascades: several maps for a sun. "
       "paraboloid: two for a lamp. warped: one for a sun, finer where more is visible."),
    of(settings::cascades, "N", "=4", "Number of maps for each sun, from near to far"),
    of(settings::filter, "FILTER", "=none", "Filter of shadow maps",
       "none: one texel is compared. pcf: --pcf by --pcf texels. poisson: sixteen in a disc. vsm, "
       "esm, msm: variance, exponential, moment maps. pcss: percentage-closer soft shadows."),
    of(settings::pcf, "N", "1; with --filter pcf 3, with poisson, vsm, esm or msm 5",
       "Width of the map filter in texels", "1: hard edges."),
    of(settings::soft, "WORD", "=none", "Shadows that maps give lights with an extent",
       "none: hard shadows of all their points, averaged. pcf, pcss: the map of their centre, "
       "filtered as wide as --pcf says, or as percentage-closer soft shadows.")};

const std::vector<Option> laboratory = {
    of(settings::layout, "WORD", "=adapted", "Records that volumes are drawn from",
       "adapted: planes, where the scene needs them. published: opposite vertices. brute-force: "
       "every triangle has a volume."),
    of(settings::multiplicity, "METHOD",
       "plane; reference-edge with --layout published, triangle with brute-force",
       "Method that finds the facing of a triangle", "single-edge is not robust."),
    of(settings::silhouette, "WORD", "proposed; all unless --layout is adapted",
       "Plane-pair records that reach the vertex shader",
       "proposed: those that can be silhouettes for the light."),
    of(settings::count, "WORD", "=z-fail", "Part of brute-force volumes to count",
       "z-fail: behind surfaces. z-pass: before them, and before the near plane as the light sees "
       "it."),
    of(settings::planes, "N", "=4",
       "Number of planes that receive shadows, the largest of the scene"),
    of(settings::instancing, "WORD", "=auto", "How records reach the vertex shader",
       "on: a record for each instance. off: a copy for each vertex. multi-draw: a draw for each "
       "side, which plane-pair records have always. auto: on if the GL can."),
    of(settings::depthSlices, "N", "=auto",
       "Number of parts by depth, each with its own depth range", "auto: as many as pay."),
    of(settings::warp, "WORD", "=rectilinear", "Grid of warped maps",
       "rectilinear: columns and rows have their own widths and heights. non-orthogonal: so do the "
       "cells of each row and column."),
    {"--synthetic", usual(bench), "Time generated edges instead of a file",
     "10,000 to 90,000 edges of multiplicity 1 to 9 in every layout, vertex work alone, with the "
     "thesis' Equation 6.10 fitted."},
    {"--debug WORD", words({"none", "volumes", "primitive-map"}), "=none", render,
     "Tint the picture, and say what --explain says",
     "volumes: sides orange, with caps red, counting twice green; caps blue. primitive-map: blue "
     "if a depth alone decides, green to red the more triangles are tested."},
    {"--gl-limits WORD", words({"device", "es2-minimum"}), "=device", sees, "Part of the GL to use",
     "es2-minimum: what every OpenGL ES 2.0 has, with no extensions, 8 attributes and 16 bits of "
     "depth."}};

const std::vector<Option> help = {{"--help", all, "Show the usual options"},
                                  {"--help-all", all, "Show every option, by group"}};

std::vector<OptionGroup> groups() {
    return {{"Picture", picture},
            {"Lights", lights},
            {"Shadows", shadows},
            {"Materials and ambient light", materials},
            {"Meshes", meshes},
            {"Hours of sunlight", sunlight},
            {"Measuring and reports", measuring},
            {"Limits for files", limits},
            {"Shadow maps, for comparison", maps},
            {"Laboratory, for comparison", laboratory},
            {"Help", help}};
}

} // namespace
} // namespace edgeshade::cli::rows

namespace edgeshade::cli {

const std::vector<OptionGroup>& optionTable() {
    static const std::vector<OptionGroup> groups = rows::groups();
    return groups;
}

} // namespace edgeshade::cli
