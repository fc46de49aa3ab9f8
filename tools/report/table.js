// The overview: verdict, sections, and a row for each comparison.

function headline_metrics(entries) {
  return kHeadline.filter((name) => entries.some((entry) => name in entry.metrics)).slice(0, 7);
}

// The last runs of one metric as a line; its last point is red where the comparison failed.
function sparkline(entry, metric, width = 132, height = 30) {
  const values = entry.history.map((run) => run.metrics[metric]).filter((value) => typeof value === "number");
  if (values.length < 2) return make("span", { class: "small" }, values.length === 1 ? "first run" : "");
  const low = Math.min(...values), high = Math.max(...values);
  const x = (i) => 4 + i * (width - 8) / (values.length - 1);
  const y = (value) => high > low ? height - 4 - (value - low) / (high - low) * (height - 8) : height / 2;
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  const about = `${metric_label(metric)} over ${values.length} runs: ${number_text(values[0])} at first, ${number_text(values.at(-1))} now, between ${number_text(low)} and ${number_text(high)}`;
  for (const [key, value] of Object.entries({ class: "spark", width, height, viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": about })) svg.setAttribute(key, value);
  const title = document.createElementNS(svg.namespaceURI, "title");
  title.textContent = about;
  const line = document.createElementNS(svg.namespaceURI, "polyline");
  line.setAttribute("points", values.map((value, i) => `${x(i).toFixed(1)},${y(value).toFixed(1)}`).join(" "));
  const dot = document.createElementNS(svg.namespaceURI, "circle");
  for (const [key, value] of Object.entries({ cx: x(values.length - 1), cy: y(values.at(-1)), r: 2.8, class: entry.held ? "" : "failed" })) dot.setAttribute(key, value);
  svg.append(title, line, dot);
  return svg;
}

function metric_cell(entry, name) {
  const cell = make("td");
  if (!(name in entry.metrics)) return cell;
  const limit = entry.limits.find((one) => one.metric === name);
  cell.append(number_text(entry.metrics[name]));
  if (limit) {
    cell.classList.toggle("failed", !limit.held);
    cell.append(make("small", {}, limit_text(limit)));
  }
  return cell;
}

function table_row(entry, names, trend) {
  const link = "#entry=" + entry.id;
  const text = make("td", { class: "text" }, make("a", { href: link }, entry.name), " ", kind_badge(entry.kind));
  const about = [entry.scene, entry.reason].filter(Boolean);
  if (about.length) text.append(make("p", {}, about.join(" · ")));
  for (const limit of entry.limits.filter((one) => !names.includes(one.metric)))
    text.append(make("p", limit.held ? {} : { class: "failed" }, `${metric_label(limit.metric)} ${number_text(entry.metrics[limit.metric])} (${limit_text(limit)})`));
  const thumbs = make("a", { class: "thumbs", href: link, tabindex: "-1", "aria-hidden": "true" });
  for (const which of ["reference", "test", "heat"]) thumbs.append(make("img", { src: entry.thumbnails[which], alt: "", title: which === "heat" ? "heat map" : which, loading: "lazy" }));
  return make("tr", {}, make("td", {}, thumbs), text, make("td", {}, verdict_mark(entry)), ...names.map((name) => metric_cell(entry, name)),
    make("td", {}, sparkline(entry, trend)));
}

function fill_table() {
  const entries = tyndall_report.entries, names = headline_metrics(entries);
  const trend = document.getElementById("trend_metric").value;
  const head = make("tr", {}, make("th", { scope: "col", class: "text" }, "reference, test, heat map"), make("th", { scope: "col", class: "text" }, "comparison"), make("th", { scope: "col" }, "verdict"),
    ...names.map((name) => make("th", { scope: "col", title: metric_about(name) }, metric_label(name))), make("th", { scope: "col" }, "past runs"));
  document.querySelector("#comparisons thead").replaceChildren(head);
  const shown = entries.filter((entry) => !entry.held || !document.getElementById("only_failed").checked);
  document.querySelector("#comparisons tbody").replaceChildren(...shown.map((entry) => table_row(entry, names, trend)));
}

function fill_verdict(entries) {
  const failed = entries.filter((entry) => !entry.held).length, judged = entries.filter((entry) => !entry.held || entry.limits.length).length;
  const verdict = document.getElementById("verdict");
  verdict.className = "verdict" + (failed ? " failed" : judged ? " held" : "");
  verdict.textContent = failed ? `${failed} of ${entries.length} comparisons failed` : judged === 0 ? `${entries.length} comparisons, none held against a limit`
    : judged === 1 && entries.length === 1 ? "The comparison held" : `${judged} comparisons held` + (judged < entries.length ? `, ${entries.length - judged} not judged` : "");
  verdict.hidden = entries.length === 0;
  document.getElementById("only_failed_label").hidden = failed === 0 || failed === entries.length;
}

function fill_overview() {
  const report = tyndall_report, entries = report.entries;
  document.title = report.title;
  document.getElementById("title").textContent = report.title;
  document.getElementById("introduction").textContent = report.introduction;
  fill_verdict(entries);
  const facts = [["made", report.time], ["revision", report.revision], ...report.facts];
  document.getElementById("facts").append(...facts.map(([key, value]) => make("div", {}, make("dt", {}, key), make("dd", {}, value))));
  for (const section of report.sections) {
    const block = make("section", { class: "block" }, make("h2", {}, section.title));
    block.insertAdjacentHTML("beforeend", section.html);
    document.getElementById("sections").append(block);
  }
  document.getElementById("table_part").hidden = entries.length === 0;
  const names = [...new Set(entries.flatMap((entry) => Object.keys(entry.metrics)))];
  const trend = document.getElementById("trend_metric");
  trend.append(...names.map((name) => make("option", { value: name }, metric_label(name))));
  trend.value = kHeadline.find((name) => names.includes(name)) ?? names[0] ?? "";
  trend.addEventListener("change", fill_table);
  document.getElementById("only_failed").addEventListener("change", fill_table);
  const kinds = [...new Set(entries.map((entry) => entry.kind))];
  document.getElementById("kinds").append(...kinds.flatMap((kind, i) => [i ? " · " : "", kind_badge(kind), " " + kKinds[kind][1]]));
  fill_table();
}
