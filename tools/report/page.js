// Which part is shown, by the address's hash, and what stands beside the pictures.

function fill_metrics(entry) {
  const known = Object.keys(kMetrics).filter((name) => name in entry.metrics);
  const others = Object.keys(entry.metrics).filter((name) => !(name in kMetrics));
  by_id("metrics").replaceChildren(...[...known, ...others].map((name) => {
    const limit = entry.limits.find((one) => one.metric === name), cell = make("td", {}, number_text(entry.metrics[name]));
    const head = make("th", { scope: "row", title: metric_about(name) }, metric_label(name));
    if (limit) {
      cell.classList.add(limit.held ? "held" : "failed");
      cell.append(make("small", {}, limit_text(limit)));
      if (limit.reason) head.append(make("small", {}, limit.reason));
    }
    return make("tr", {}, head, cell);
  }));
}

function fill_notes(entry) {
  const notes = entry.notes.map((text) => make("p", { class: "note" }, text));
  if (entry.kind === "baseline") notes.unshift(make("p", { class: "note warn" }, "No truth backs this comparison: it is held against an earlier picture of the same technique."));
  by_id("notes").replaceChildren(...notes);
}

function fill_worst(entry) {
  by_id("worst_part").hidden = entry.worst.length === 0;
  by_id("worst").replaceChildren(...entry.worst.map(([x, y]) => {
    const button = make("button", { type: "button" }, `${x}, ${y}`);
    button.addEventListener("click", () => {
      if (!viewer.picture) return;
      Object.assign(viewer, { x: x + 4, y: y + 4, fitted: false });
      set_probe(Math.min(x + 4, entry.width - 1), Math.min(y + 4, entry.height - 1));
      zoom_to(Math.max(viewer.zoom, 16));
    });
    return button;
  }));
}

function fill_past(entry) {
  const names = kHeadline.filter((name) => name in entry.metrics);
  const rows = names.map((name) => make("tr", {}, make("th", { scope: "row" }, metric_label(name)), make("td", {}, sparkline(entry, name, 150, 26))));
  const table = make("table", { class: "plain" }, make("tbody", {}, ...rows));
  by_id("past").replaceChildren(entry.history.length > 1 ? table : make("p", { class: "small" }, "This is the first run that is kept."));
}

function show_entry(entry) {
  const entries = tyndall_report.entries, index = entries.indexOf(entry), count = entries.length;
  by_id("viewer_title").replaceChildren(entry.name, " ", verdict_mark(entry));
  by_id("viewer_about").replaceChildren(kind_badge(entry.kind), " " + [entry.scene, entry.reason, `${entry.width} × ${entry.height} pixels`].filter(Boolean).join(" · "));
  by_id("previous").href = "#entry=" + entries[(index + count - 1) % count].id;
  by_id("next").href = "#entry=" + entries[(index + 1) % count].id;
  for (const id of ["previous", "next"]) by_id(id).hidden = count < 2;
  fill_notes(entry);
  fill_metrics(entry);
  fill_worst(entry);
  fill_past(entry);
  open_viewer(entry);
}

function route() {
  const entry = tyndall_report.entries.find((one) => location.hash === "#entry=" + one.id);
  by_id("overview").hidden = entry !== undefined;
  by_id("viewer").hidden = entry === undefined;
  if (!entry) return;
  show_entry(entry);
  window.scrollTo(0, 0);
  by_id("viewer_title").focus({ preventScroll: true });
}

fill_overview();
set_up_viewer();
window.addEventListener("hashchange", route);
route();
