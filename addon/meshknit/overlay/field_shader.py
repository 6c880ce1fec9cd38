"""The shader of the live field: colours of time, and a line wherever a row would lie."""

from ..core import colors

LINE = (0.12, 0.12, 0.14)
LINE_STRENGTH = 0.55
LINE_WIDTH = 1.3  # pixels of a screen of usual resolution

_shader = None

_VERTEX = """
void main() {
  shown_time = time;
  shown_row = row;
  place = pos;
  gl_Position = to_screen * vec4(pos, 1.0);
}
"""

# What is drawn over a 3D view is encoded as sRGB when it is written; shaders of one's own get none of
# the conversion that Blender puts into its own. Where rows lie closer than a few pixels, lines fade before they become a pattern of their own.
_FRAGMENT = """
vec3 time_color(float time) {
%(stops)s
  return color;
}

vec3 to_linear(vec3 color) {
  vec3 low = color / 12.92, high = pow((color + 0.055) / 1.055, vec3(2.4));
  return mix(low, high, step(vec3(0.04045), color));
}

void main() {
  vec3 color = time_color(clamp(shown_time, -1.0, 1.0));
  float rows_a_pixel = max(fwidth(shown_row), 1e-6);
  float from_line = abs(fract(shown_row + 0.5) - 0.5) / rows_a_pixel;
  float strength = 1.0 - smoothstep(0.5 * line_width, 0.5 * line_width + 1.0, from_line);
  strength *= 1.0 - smoothstep(0.2, 0.45, rows_a_pixel);
  color = mix(color, vec3(%(line)s), lines * strength);
  vec3 normal = cross(dFdx(place), dFdy(place));
  float facing = abs(dot(normal, towards_viewer)) / max(length(normal), 1e-20);
  color *= 0.72 + 0.28 * facing;
  float grey = dot(color, vec3(1.0 / 3.0));
  color = mix(color, vec3(grey), 0.75 * stale);
  fragment = vec4(to_linear(color), 1.0);
}
"""


def field_shader():
    """Takes `pos` (vec3), `time` and `row` (float) a vertex. Compiled when first drawn."""
    global _shader
    if _shader is None:
        _shader = _compile()
    return _shader


def fragment_source():
    """As text, without a GPU."""
    return _FRAGMENT % {
        "stops": _stops(),
        "line": ", ".join(f"{c:.4f}" for c in LINE),
    }


def _stops():
    """The colour scale as a chain of mixes, so that it is the one that Python uses."""
    times, shades = colors.time_stops()
    text = [f"  vec3 color = {_vector(shades[0])};"]
    for i in range(1, len(times)):
        part = f"clamp((time - ({times[i - 1]:.6f})) / {times[i] - times[i - 1]:.6f}, 0.0, 1.0)"
        text.append(f"  color = mix(color, {_vector(shades[i])}, {part});")
    return "\n".join(text)


def _vector(shade):
    return "vec3(" + ", ".join(f"{c:.4f}" for c in shade) + ")"


def _compile():
    import gpu

    info = gpu.types.GPUShaderCreateInfo()
    # Together no more than 128 bytes, which every GPU has room for.
    info.push_constant("MAT4", "to_screen")
    info.push_constant("VEC3", "towards_viewer")
    info.push_constant("FLOAT", "lines")
    info.push_constant("FLOAT", "stale")
    info.push_constant("FLOAT", "line_width")
    info.vertex_in(0, "VEC3", "pos")
    info.vertex_in(1, "FLOAT", "time")
    info.vertex_in(2, "FLOAT", "row")
    between = gpu.types.GPUStageInterfaceInfo("meshknit_field")
    between.smooth("FLOAT", "shown_time")
    between.smooth("FLOAT", "shown_row")
    between.smooth("VEC3", "place")
    info.vertex_out(between)
    info.fragment_out(0, "VEC4", "fragment")
    info.vertex_source(_VERTEX)
    info.fragment_source(fragment_source())
    return gpu.shader.create_from_info(info)
