// One comparison: two of reference, test and heat map under a wipe.

const by_id = (id) => document.getElementById(id);
const kSides = { reference: "Reference", test: "Test", heat: "Heat map" };

const viewer = {
  entry: null, picture: null, floor: 0,
  layers: {},                    // "reference", "test", "heat" -> canvas of the picture's size
  zoom: 1, x: 0, y: 0,           // screen pixels per picture pixel; the picture's point in the middle of the stage
  fitted: true, wipe: 0.5,
  probe: null,                   // [x, y] of the pixel that is read
};

function stage_size() { const box = by_id("stage").getBoundingClientRect(); return [box.width, box.height]; }
function exposure_factor() { return viewer.entry.exposure * 2 ** Number(by_id("exposure").value); }
function heat_choice() { return heat_choices(viewer.entry).find((choice) => choice.name === by_id("heat").value); }
// What is drawn brightest: the map's own full scale, or what is white at the entry's exposure, less the gain.
function heat_full() { return (heat_choice().full ?? 0.25 / viewer.entry.exposure) / 2 ** Number(by_id("gain").value); }

function layer(which) {
  const { layers, picture } = viewer;
  if (!layers[which]) layers[which] = which === "heat" ? draw_heat(picture, heat_choice(), heat_full(), viewer.floor) : develop(picture, picture[which], exposure_factor());
  return layers[which];
}

function draw_side(context, which, from, to, height, scale) {
  const { picture, zoom, x, y } = viewer, [stage_width, stage_height] = stage_size();
  context.save();
  context.beginPath();
  context.rect(from * scale, 0, (to - from) * scale, height * scale);
  context.clip();
  context.imageSmoothingEnabled = zoom * scale < 1;
  context.imageSmoothingQuality = "high";
  context.drawImage(layer(which), (stage_width / 2 - x * zoom) * scale, (stage_height / 2 - y * zoom) * scale, picture.width * zoom * scale, picture.height * zoom * scale);
  context.restore();
}

function draw_probe(context, scale) {
  if (!viewer.probe) return;
  const { zoom, x, y, probe } = viewer, [width, height] = stage_size(), size = Math.max(zoom * scale, 6);
  const middle = [(width / 2 + (probe[0] + 0.5 - x) * zoom) * scale, (height / 2 + (probe[1] + 0.5 - y) * zoom) * scale];
  for (const [colour, grow] of [["#000", 1], ["#fff", 0]]) {
    context.strokeStyle = colour;
    context.lineWidth = 1;
    context.strokeRect(Math.round(middle[0] - size / 2) - 0.5 - grow, Math.round(middle[1] - size / 2) - 0.5 - grow, Math.round(size) + 2 * grow, Math.round(size) + 2 * grow);
  }
}

function draw() {
  if (!viewer.picture) return;
  const canvas = by_id("canvas"), [width, height] = stage_size(), scale = window.devicePixelRatio || 1;
  if (viewer.fitted) fit();
  canvas.width = Math.round(width * scale);
  canvas.height = Math.round(height * scale);
  const context = canvas.getContext("2d"), at = viewer.wipe * width;
  draw_side(context, by_id("left").value, 0, at, height, scale);
  draw_side(context, by_id("right").value, at, width, height, scale);
  draw_probe(context, scale);
  by_id("zoom_value").textContent = `${number_text(100 * viewer.zoom, 3)} %`;
}

function show_wipe() {
  const percent = Math.round(100 * viewer.wipe);
  by_id("wipe").style.left = `${100 * viewer.wipe}%`;
  by_id("wipe").setAttribute("aria-valuenow", percent);
  by_id("wipe").setAttribute("aria-valuetext", `${percent} % ${kSides[by_id("left").value]}, ${100 - percent} % ${kSides[by_id("right").value]}`);
}
function set_wipe(share) { viewer.wipe = Math.min(Math.max(share, 0), 1); show_wipe(); draw(); }

function fit() {
  const { picture } = viewer, [width, height] = stage_size();
  Object.assign(viewer, { zoom: Math.min(width / picture.width, height / picture.height), x: picture.width / 2, y: picture.height / 2 });
}
// Keeps the point under (left, top) of the stage where it is.
function zoom_to(zoom, left, top) {
  const [width, height] = stage_size(), dx = (left ?? width / 2) - width / 2, dy = (top ?? height / 2) - height / 2;
  const before = viewer.zoom, after = Math.min(Math.max(zoom, 1 / 32), 64);
  viewer.x += dx / before - dx / after;
  viewer.y += dy / before - dy / after;
  Object.assign(viewer, { zoom: after, fitted: false });
  draw();
}

function read_probe() {
  const { picture, probe, entry } = viewer, rows = by_id("readout");
  by_id("pixel").textContent = probe ? `x ${probe[0]}, y ${probe[1]}` : "point at a pixel";
  by_id("heat_head").textContent = heat_choice().label;
  const row = (title, values, last = "") => make("tr", {}, make("th", { scope: "row", class: "left" }, title), ...values.map((value) => make("td", {}, value)), make("td", {}, last));
  if (!probe) return rows.replaceChildren(row("Reference", ["", "", "", ""]), row("Test", ["", "", "", ""]), row("Test − reference", ["", "", "", ""]));
  const pixel = probe[1] * picture.width + probe[0], at = 3 * pixel;
  const four = (values) => [values[at], values[at + 1], values[at + 2], luminance(values, at)];
  const r = four(picture.reference), t = four(picture.test), digits = picture.format === "f32" ? 5 : 4;
  const text = (values) => values.map((value) => number_text(value, digits));
  rows.replaceChildren(row("Reference", text(r)), row("Test", text(t)),
    row("Test − reference", text(t.map((value, i) => value - r[i])), number_text(heat_value(picture, heat_choice(), pixel, viewer.floor), 3)));
  by_id("readout").dataset.entry = entry.id;
}
function set_probe(x, y) {
  const { width, height } = viewer.picture;
  viewer.probe = x < 0 || y < 0 || x >= width || y >= height ? null : [x, y];
  read_probe();
  draw();
}
function probe_under(event) {
  const box = by_id("stage").getBoundingClientRect(), { zoom, x, y } = viewer;
  set_probe(Math.floor(x + (event.clientX - box.left - box.width / 2) / zoom), Math.floor(y + (event.clientY - box.top - box.height / 2) / zoom));
}

function exposure_changed() {
  const stops = Number(by_id("exposure").value);
  by_id("exposure_value").textContent = `${stops > 0 ? "+" : stops < 0 ? "−" : ""}${Math.abs(stops)} EV`;
  viewer.layers = { heat: viewer.layers.heat };
  draw();
}
function heat_changed() {
  const full = number_text(heat_full(), 3), choice = heat_choice();
  by_id("gain_value").textContent = `× ${number_text(2 ** Number(by_id("gain").value), 3)}`;
  by_id("legend_value").textContent = choice.signed ? `±${full}` : `0 … ${full}`;
  const context = by_id("legend").getContext("2d"), image = context.createImageData(160, 10);
  for (let i = 0; i < 1600; ++i) ramp_colour(choice.signed ? kDiverging : kRamp, (i % 160) / 159, image.data, 4 * i);
  context.putImageData(image, 0, 0);
  viewer.layers.heat = null;
  read_probe();
  draw();
}
function sides_changed() {
  for (const side of ["left", "right"]) {
    const which = by_id(side).value, name = which === "heat" ? heat_choice().label : viewer.entry[which + "_name"];
    by_id(side + "_label").textContent = name && name !== kSides[which] ? `${kSides[which]}: ${name}` : kSides[which];
  }
  show_wipe();
  draw();
}

function step(id, by) {
  const input = by_id(id);
  input.value = Number(input.value) + by;
  input.dispatchEvent(new Event("input"));
}
function reset_exposure() { by_id("exposure").value = 0; exposure_changed(); }
function move_probe(dx, dy) {
  const { picture, probe } = viewer, [x, y] = probe ?? [picture.width >> 1, picture.height >> 1];
  if (!probe) return set_probe(x, y);
  set_probe(Math.min(Math.max(x + dx, 0), picture.width - 1), Math.min(Math.max(y + dy, 0), picture.height - 1));
}

const kKeys = {
  ArrowLeft: (far) => set_wipe(viewer.wipe - (far ? 0.1 : 0.01)), ArrowRight: (far) => set_wipe(viewer.wipe + (far ? 0.1 : 0.01)),
  Home: () => set_wipe(0), End: () => set_wipe(1),
  "+": () => step("exposure", 0.25), "=": () => step("exposure", 0.25), "-": () => step("exposure", -0.25), 0: reset_exposure,
  "[": () => zoom_to(viewer.zoom / 1.25), "]": () => zoom_to(viewer.zoom * 1.25), f: () => { viewer.fitted = true; draw(); }, 1: () => zoom_to(1),
  w: (far) => move_probe(0, far ? -8 : -1), s: (far) => move_probe(0, far ? 8 : 1), a: (far) => move_probe(far ? -8 : -1, 0), d: (far) => move_probe(far ? 8 : 1, 0),
  h: () => { by_id("right").value = by_id("right").value === "heat" ? "test" : "heat"; sides_changed(); },
  n: () => by_id("next").click(), p: () => by_id("previous").click(), Escape: () => by_id("back").click(),
};
function key_pressed(event) {
  if (by_id("viewer").hidden || !viewer.picture || event.ctrlKey || event.metaKey || event.altKey) return;
  // A slider or a list in focus takes its own keys; + and - still mean the exposure, Escape still leaves.
  const busy = event.target.matches("select, input") && !["+", "-", "=", "Escape"].includes(event.key);
  const act = kKeys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (busy || !act) return;
  act(event.shiftKey);
  event.preventDefault();
}

// Calls move(event, dx, dy) while the pointer is down on the element.
function on_drag(element, move) {
  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !viewer.picture) return;
    let last = [event.clientX, event.clientY];
    const moved = (now) => { move(now, now.clientX - last[0], now.clientY - last[1]); last = [now.clientX, now.clientY]; };
    element.setPointerCapture(event.pointerId);
    element.addEventListener("pointermove", moved);
    element.addEventListener("lostpointercapture", () => element.removeEventListener("pointermove", moved), { once: true });
  });
}

function set_up_viewer() {
  for (const [id, react] of [["left", sides_changed], ["right", sides_changed], ["heat", () => { heat_changed(); sides_changed(); }]]) by_id(id).addEventListener("change", react);
  by_id("exposure").addEventListener("input", exposure_changed);
  by_id("gain").addEventListener("input", heat_changed);
  by_id("exposure_reset").addEventListener("click", reset_exposure);
  for (const [id, act] of [["zoom_in", "]"], ["zoom_out", "["], ["zoom_fit", "f"], ["zoom_one", 1]]) by_id(id).addEventListener("click", () => kKeys[act]());
  const stage = by_id("stage"), canvas = by_id("canvas");
  on_drag(by_id("wipe"), (event) => { const box = stage.getBoundingClientRect(); set_wipe((event.clientX - box.left) / box.width); });
  on_drag(canvas, (event, dx, dy) => { viewer.x -= dx / viewer.zoom; viewer.y -= dy / viewer.zoom; viewer.fitted = false; draw(); });
  stage.addEventListener("pointermove", (event) => { if (viewer.picture && event.buttons === 0) probe_under(event); });
  stage.addEventListener("wheel", (event) => {
    if (!viewer.picture) return;
    const box = stage.getBoundingClientRect();
    zoom_to(viewer.zoom * 1.0015 ** -event.deltaY, event.clientX - box.left, event.clientY - box.top);
    event.preventDefault();
  }, { passive: false });
  document.addEventListener("keydown", key_pressed);
  new ResizeObserver(draw).observe(stage);
}

function show_pictures(picture) {
  Object.assign(viewer, { picture, layers: {}, floor: floor_of(picture) });
  by_id("waiting").hidden = true;
  exposure_changed();
  heat_changed();
  sides_changed();
}

function open_viewer(entry) {
  by_id("stage").style.aspectRatio = `${entry.width} / ${entry.height}`;
  Object.assign(viewer, { entry, picture: null, layers: {}, fitted: true, wipe: 0.5, probe: null });
  for (const [side, which] of [["left", "reference"], ["right", "test"]]) {
    by_id(side).replaceChildren(...Object.entries(kSides).map(([value, label]) => make("option", { value }, label)));
    by_id(side).value = which;
  }
  by_id("heat").replaceChildren(...heat_choices(entry).map((choice) => make("option", { value: choice.name }, choice.label)));
  for (const id of ["exposure", "gain"]) by_id(id).value = 0;
  by_id("waiting").hidden = false;
  by_id("waiting").textContent = "Reading the pictures…";
  load_picture(entry.id).then((picture) => { if (viewer.entry === entry) show_pictures(picture); },
    (error) => { by_id("waiting").textContent = error.message; });
}
