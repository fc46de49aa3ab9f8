// Scene-linear pictures, as data/*.js hands them over, and their development to pixels.

const kWaiting = new Map();  // id -> { promise, resolve }

function tyndall_pixels(id, data) { kWaiting.get(id)?.resolve(decoded(data)); }

function load_picture(id) {
  const known = kWaiting.get(id);
  if (known) return known.promise;
  const waiting = {};
  waiting.promise = new Promise((resolve, reject) => {
    waiting.resolve = resolve;
    const script = make("script", { src: `data/${id}.js` });
    script.addEventListener("error", () => { kWaiting.delete(id); reject(new Error(`data/${id}.js cannot be read: it belongs beside this page`)); });
    document.head.append(script);
  });
  kWaiting.set(id, waiting);
  return waiting.promise;
}

function bytes_of(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

function float_of_half(half) {
  const sign = half & 0x8000 ? -1 : 1, exponent = half >> 10 & 31, fraction = half & 1023;
  if (exponent === 31) return fraction ? NaN : sign * Infinity;
  return sign * (exponent ? 2 ** (exponent - 15) * (1 + fraction / 1024) : 2 ** -14 * fraction / 1024);
}

// Both forms are little-endian, as all machines are that show web pages.
function floats_of(base64, format, scale) {
  const buffer = bytes_of(base64).buffer;
  if (format === "f32") return new Float32Array(buffer);
  const table = new Float32Array(65536);
  for (let i = 0; i < 65536; ++i) table[i] = float_of_half(i) * scale;
  return Float32Array.from(new Uint16Array(buffer), (half) => table[half]);
}

function decoded(data) {
  const picture = { width: data.width, height: data.height, format: data.format, maps: {} };
  for (const which of ["reference", "test"]) picture[which] = floats_of(data[which], data.format, data.scale);
  for (const [name, text] of Object.entries(data.maps)) picture.maps[name] = bytes_of(text);
  return picture;
}

const kLuminance = [0.2126, 0.7152, 0.0722];  // Rec.709
function luminance(values, at) { return kLuminance[0] * values[at] + kLuminance[1] * values[at + 1] + kLuminance[2] * values[at + 2]; }

const kEncode = new Uint8Array(16385);  // sRGB over 0..1
for (let i = 0; i <= 16384; ++i) {
  const x = i / 16384;
  kEncode[i] = Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
}

function canvas_of(picture, paint) {
  const canvas = make("canvas", { width: picture.width, height: picture.height });
  const context = canvas.getContext("2d"), image = context.createImageData(picture.width, picture.height);
  paint(image.data);
  context.putImageData(image, 0, 0);
  return canvas;
}

// Scene-linear values times `factor`, as a display's sRGB; what is no number is magenta.
function develop(picture, values, factor) {
  return canvas_of(picture, (out) => {
    for (let i = 0, o = 0; i < values.length; i += 3, o += 4) {
      const sum = values[i] + values[i + 1] + values[i + 2], good = sum - sum === 0;
      for (let c = 0; c < 3; ++c) {
        const x = values[i + c] * factor;
        out[o + c] = good ? kEncode[x > 0 ? x < 1 ? x * 16384 + 0.5 | 0 : 16384 : 0] : c === 1 ? 0 : 255;
      }
      out[o + 3] = 255;
    }
  });
}

// Heat maps: those the page computes from the pictures, and those the entry brings.
const kComputedMaps = [
  { name: "relative", label: "Relative error", full: 1 },
  { name: "absolute", label: "Absolute difference", full: null },
  { name: "signed", label: "Signed difference", full: null, signed: true },
];
function heat_choices(entry) { return [...entry.maps, ...kComputedMaps]; }

// The value of a map at one pixel (index of the pixel, not of its red).
function heat_value(picture, choice, pixel, floor) {
  const { reference: r, test: t } = picture, at = 3 * pixel;
  if (choice.name === "signed") return luminance(t, at) - luminance(r, at);
  if (choice.name === "absolute") return Math.max(Math.abs(t[at] - r[at]), Math.abs(t[at + 1] - r[at + 1]), Math.abs(t[at + 2] - r[at + 2]));
  if (choice.name !== "relative") return picture.maps[choice.name][pixel] / 255 * choice.full;
  let sum = 0;
  for (let c = at; c < at + 3; ++c) sum += (t[c] - r[c]) ** 2 / (r[c] ** 2 + floor);
  return Math.sqrt(sum / 3);
}

// (0.1 mean r)^2, the floor under the relative error's denominator.
function floor_of(picture) {
  let sum = 0;
  for (const value of picture.reference) sum += value;
  return Math.max((0.1 * sum / picture.reference.length) ** 2, 1e-30);
}

const kRamp = [[0, 0, 4], [87, 16, 110], [188, 55, 84], [249, 142, 9], [252, 255, 164]];
const kDiverging = [[33, 102, 172], [146, 197, 222], [24, 24, 24], [244, 165, 130], [178, 24, 43]];
// 0..1 on a ramp of five colours.
function ramp_colour(ramp, value, out, at) {
  const x = 4 * Math.min(Math.max(value, 0), 1), low = Math.min(x | 0, 3), share = x - low;
  for (let c = 0; c < 3; ++c) out[at + c] = Math.round(ramp[low][c] + share * (ramp[low + 1][c] - ramp[low][c]));
  out[at + 3] = 255;
}
function ramp_position(choice, value, full) {
  if (Number.isNaN(value)) return 1;
  return choice.signed ? 0.5 + 0.5 * value / full : value / full;
}

function draw_heat(picture, choice, full, floor) {
  const ramp = choice.signed ? kDiverging : kRamp;
  return canvas_of(picture, (out) => {
    for (let i = 0; i < picture.width * picture.height; ++i) ramp_colour(ramp, ramp_position(choice, heat_value(picture, choice, i, floor), full), out, 4 * i);
  });
}
