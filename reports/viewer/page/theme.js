// The canvas takes its colours from the style sheet, so that light and dark are told in one file.
const kColours = ["canvas", "outside", "ink", "area", "path", "transit", "enforced", "deleted", "edit", "robot",
                  "label", "halo", "accent", "sand", "raked", "groove", "track", "sand-outside"];
const colour = {};

function readColours() {
  const style = getComputedStyle(document.documentElement);
  for (const name of kColours) colour[name] = style.getPropertyValue("--" + name).trim();
}
readColours();

/** Of a trace by its number: hues far from each other. */
const traceColour = i => `hsl(${(200 + 137 * i) % 360} 65% 50%)`;
