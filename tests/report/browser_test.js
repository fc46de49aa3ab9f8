"use strict";
// What a person does with a report, in headless Chromium. browser_test.py makes the report and says what must be seen.

const assert = require("node:assert/strict");
const { chromium } = require("playwright-core");

const facts = JSON.parse(process.argv[2]);
const near = (value, expected, tolerance, what) => assert.ok(Math.abs(value - expected) <= tolerance, `${what}: ${value}, expected ${expected} ± ${tolerance}`);
const number = (text) => Number(text.replace("−", "-"));
const encoded = (x) => 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * Math.min(x, 1) ** (1 / 2.4) - 0.055);

async function overview(page) {
  assert.equal(await page.locator("#comparisons tbody tr").count(), 2);
  assert.match(await page.locator("#verdict").textContent(), /1 of 2 comparisons failed/);
  assert.equal(await page.locator("#comparisons .mark.failed").count(), 1);
  assert.equal(await page.locator("#comparisons svg.spark").count(), 2, "two runs make a sparkline");
  const sizes = await page.locator("#comparisons img").evaluateAll((images) => images.map((image) => image.naturalWidth));
  assert.ok(sizes.length === 6 && sizes.every((size) => size > 0), `thumbnails: ${sizes}`);
  await page.check("#only_failed");
  assert.equal(await page.locator("#comparisons tbody tr").count(), 1);
  await page.screenshot({ path: `${facts.screenshots}/overview.png` });
  await page.uncheck("#only_failed");
}

async function open_by_keyboard(page) {
  await page.locator("#comparisons td.text a", { hasText: "far.exr" }).focus();
  await page.keyboard.press("Enter");
  await page.locator("#waiting").waitFor({ state: "hidden" });
  assert.match(await page.locator("#viewer_title").textContent(), /far\.exr.*failed/);
}

// Where a pixel of the picture lies on the screen (its middle), in the viewport.
const place_of = (page, x, y) => page.evaluate(([px, py]) => {
  const box = document.getElementById("stage").getBoundingClientRect();
  return [box.left + box.width / 2 + (px + 0.5 - viewer.x) * viewer.zoom, box.top + box.height / 2 + (py + 0.5 - viewer.y) * viewer.zoom];
}, [x, y]);

// The colour that is drawn there.
const colour_at = (page, x, y) => page.evaluate(([left, top]) => {
  const canvas = document.getElementById("canvas"), box = canvas.getBoundingClientRect(), scale = canvas.width / box.width;
  return [...canvas.getContext("2d").getImageData(Math.round((left - box.left) * scale), Math.round((top - box.top) * scale), 1, 1).data].slice(0, 3);
}, [x, y]);

async function expect_colour(page, x, y, linear, factor, what) {
  const colour = await colour_at(page, ...(await place_of(page, x, y)));
  linear.forEach((value, c) => near(colour[c], encoded(value * factor), 2, `${what}, channel ${c}`));
}

async function drag_wipe(page) {
  const wipe = page.locator("#wipe"), stage = await page.locator("#stage").boundingBox();
  assert.equal(await wipe.getAttribute("aria-valuenow"), "50");
  const exposure = await page.evaluate(() => exposure_factor());
  const [left, top] = await place_of(page, facts.x, facts.y);
  assert.ok(left < stage.x + stage.width / 2, "the pixel is left of the middle");
  await expect_colour(page, facts.x, facts.y, facts.reference, exposure, "left of the wipe is the reference");
  await page.mouse.move(stage.x + stage.width / 2, top);
  await page.mouse.down();
  await page.mouse.move(left - 60, top, { steps: 5 });
  await page.mouse.up();
  near(Number(await wipe.getAttribute("aria-valuenow")), 100 * (left - 60 - stage.x) / stage.width, 1.5, "the wipe follows the pointer");
  await expect_colour(page, facts.x, facts.y, facts.test, exposure, "right of the wipe is the test");
  const before = Number(await wipe.getAttribute("aria-valuenow"));
  await wipe.focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+ArrowRight");
  near(Number(await wipe.getAttribute("aria-valuenow")), before + 11, 1, "arrow keys move the wipe");
  assert.notEqual(await page.locator("#wipe .grip").evaluate((grip) => getComputedStyle(grip).outlineStyle), "none", "the focus is seen");
}

const readout = (page, row) => page.locator("#readout tr").nth(row).locator("td").allTextContents();

async function read_pixel(page) {
  await page.mouse.move(...(await place_of(page, facts.x, facts.y)));
  assert.equal(await page.locator("#pixel").textContent(), `x ${facts.x}, y ${facts.y}`);
  const rows = [await readout(page, 0), await readout(page, 1), await readout(page, 2)];
  for (let c = 0; c < 3; ++c) {
    near(number(rows[0][c]), facts.reference[c], 2e-5 * facts.reference[c], "the reference's radiance is the EXR's");
    near(number(rows[1][c]), facts.test[c], 2e-5 * facts.test[c], "the test's radiance is the EXR's");
    near(number(rows[2][c]), facts.test[c] - facts.reference[c], 1e-5, "their difference");
  }
  await page.locator("#stage").focus();
  await page.keyboard.press("d");
  assert.equal(await page.locator("#pixel").textContent(), `x ${facts.x + 1}, y ${facts.y}`, "D moves the pixel that is read");
  await page.keyboard.press("a");
}

// The numbers behind what is drawn of a pixel: the reference left of the wipe, the test right of it.
const radiance_shown = async (page, x, y) => {
  const left_of_wipe = (await place_of(page, x, y))[0] < (await page.locator("#wipe").boundingBox()).x + 12;
  return page.evaluate(([which, at]) => [...viewer.picture[which].slice(at, at + 3)], [left_of_wipe ? "reference" : "test", 3 * (y * facts.width + x)]);
};

async function change_exposure(page) {
  const factor = await page.evaluate(() => exposure_factor());
  await page.locator("#exposure").focus();
  for (let i = 0; i < 4; ++i) await page.keyboard.press("ArrowRight");
  assert.equal(await page.locator("#exposure").inputValue(), "1");
  assert.equal(await page.locator("#exposure_value").textContent(), "+1 EV");
  await page.keyboard.press("End");
  await page.locator("#stage").focus();
  await page.keyboard.press("0");
  assert.equal(await page.locator("#exposure").inputValue(), "0");
  for (const key of ["+", "+", "-"]) await page.keyboard.press(key);
  assert.equal(await page.locator("#exposure").inputValue(), "0.25");
  await page.mouse.move(5, 5);  // the mark of the pixel that is read lies beside the one that is looked at
  const x = facts.x + 4, y = facts.y + 4;
  await expect_colour(page, x, y, await radiance_shown(page, x, y), factor * 2 ** 0.25, "the exposure is applied to the radiance");
  await page.screenshot({ path: `${facts.screenshots}/viewer.png` });
}

async function zoom_and_heat(page) {
  const zoom = () => page.evaluate(() => viewer.zoom);
  const before = await zoom(), place = await place_of(page, facts.x, facts.y);
  await page.mouse.move(...place);
  await page.mouse.wheel(0, -400);
  await page.waitForFunction((last) => viewer.zoom > last, before);
  const after = await place_of(page, facts.x, facts.y);
  near(after[0], place[0], 0.6 * (await zoom()), "the wheel zooms about the pointer");
  await page.mouse.down();
  await page.mouse.move(place[0] + 40, place[1] + 10, { steps: 3 });
  await page.mouse.up();
  near((await place_of(page, facts.x, facts.y))[0], after[0] + 40, 1, "dragging pans");
  await page.keyboard.press("f");
  for (const name of await page.locator("#heat option").evaluateAll((options) => options.map((option) => option.value))) await page.selectOption("#heat", name);
  await page.selectOption("#heat", "hdr_flip");
  await page.locator("#stage").focus();
  await page.keyboard.press("h");
  assert.match(await page.locator("#right_label").textContent(), /Heat map: HDR-FLIP/);
  await page.locator("#worst button").first().click();
  assert.ok((await zoom()) >= 16, "a worst block is shown large");
  await page.locator("#stage").focus();
  await page.keyboard.press("f");
  await page.emulateMedia({ colorScheme: "dark" });
  const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number));
  assert.ok(Math.max(...ground) < 64, `dark where the system is dark: ${ground}`);
  await page.screenshot({ path: `${facts.screenshots}/heat-dark.png` });
}

async function tab_order(page) {
  await page.locator("#back").focus();
  const seen = [];
  for (let i = 0; i < 24; ++i) {
    seen.push(await page.evaluate(() => document.activeElement.id));
    await page.keyboard.press("Tab");
  }
  const order = ["back", "previous", "next", "left", "right", "heat", "zoom_out", "zoom_in", "zoom_fit", "zoom_one", "stage", "wipe", "exposure", "exposure_reset", "gain"];
  assert.deepEqual(seen.filter((id) => order.includes(id)).slice(0, order.length), order, "Tab goes through the controls as they stand");
  await page.keyboard.press("Escape");
  await page.locator("#overview").waitFor();
  assert.ok(await page.locator("#viewer").isHidden(), "Escape goes back");
}

async function large_baseline(page) {
  await page.goto(facts.large);
  assert.match(await page.locator("#verdict").textContent(), /none held against a limit/);
  assert.match(await page.locator("#kinds").textContent(), /no truth/);
  await page.locator("#comparisons td.text a").click();
  await page.locator("#waiting").waitFor({ state: "hidden" });
  assert.match(await page.locator("#notes").textContent(), /No truth backs this comparison/);
  await page.locator("#zoom_one").click();
  await page.evaluate(([x, y]) => set_probe(x, y), [facts.x, facts.y]);
  const rows = [await readout(page, 0), await readout(page, 1)];
  facts.old.forEach((value, c) => near(number(rows[0][c]), value, 6e-4 * value, "16-bit numbers have three digits"));
  near(number(rows[1][0]), facts.new, 6e-4 * facts.new, "small ones too");
}

async function main() {
  const sandbox = process.getuid() === 0 ? ["--no-sandbox"] : [];
  const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: sandbox, timeout: 240000 });
  try {
    const context = await browser.newContext({ viewport: { width: 1440, height: 1050 }, offline: true, colorScheme: "light" });
    context.setDefaultTimeout(240000);  // a busy machine fails nothing
    const page = await context.newPage(), wrong = [];
    page.on("pageerror", (error) => wrong.push(error.stack));
    page.on("console", (message) => { if (message.type() === "error") wrong.push(message.text()); });
    page.on("request", (request) => { if (!/^(file|data|blob):/.test(request.url())) wrong.push(`asks for ${request.url()}`); });
    await page.goto(facts.page);
    for (const part of [overview, open_by_keyboard, drag_wipe, read_pixel, change_exposure, zoom_and_heat, tab_order, large_baseline]) {
      await part(page);
      console.log(`${part.name}: ok`);
    }
    assert.deepEqual(wrong, []);
  } finally {
    await browser.close();
  }
}

main().catch((error) => { console.error(error); process.exit(1); });
