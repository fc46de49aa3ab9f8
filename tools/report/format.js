"use strict";
// What the numbers are called and how they are written.

// label, whether more is better, what it is. docs/compare.md says the same at length.
const kMetrics = {
  relmse: ["relMSE", false, "mean((t-r)² / (r² + (0.1 mean r)²))"],
  hdr_flip: ["HDR-FLIP", false, "mean over the picture of the largest FLIP over exposures; 0 = the same"],
  flip: ["FLIP", false, "mean of LDR-FLIP at the picture's exposure; 0 = the same"],
  ssim: ["SSIM", true, "mean structural similarity of the encoded luminance; 1 = the same"],
  psnr_db: ["PSNR, dB", true, "of sRGB-encoded values, the reference's 99.5th percentile at 1"],
  mean_error: ["mean error", false, "|mean(test) / mean(reference) - 1|"],
  mean_ratio: ["mean ratio", null, "mean(test) / mean(reference)"],
  "mean_ratio.r": ["mean ratio, red", null, ""],
  "mean_ratio.g": ["mean ratio, green", null, ""],
  "mean_ratio.b": ["mean ratio, blue", null, ""],
  max_difference: ["largest difference", false, "largest |t-r| of a channel"],
  failing_fraction: ["failing fraction", false, "share of the pixels above the tolerance"],
  worst_block: ["worst block", false, "largest mean relative squared error of an 8x8 block"],
  flip_max: ["FLIP, largest", false, ""],
  flip_worst_block: ["FLIP, worst block", false, "largest mean FLIP of an 8x8 block"],
  hdr_flip_max: ["HDR-FLIP, largest", false, ""],
  hdr_flip_worst_block: ["HDR-FLIP, worst block", false, "largest mean HDR-FLIP of an 8x8 block"],
  ssim_min: ["SSIM, smallest", true, "of a pixel"],
  not_finite: ["NaN or Inf", false, "values of the test that are no numbers"],
  z_p: ["Z-test p", true, "probability that noise alone gives such a difference"],
  z_worst: ["largest |z|", false, "of an 8x8 block and channel"],
  z_worst_p: ["worst block p", true, "Šidák over all blocks and channels"],
  z_spread: ["mean z²", null, "1 when the pictures differ by their noise alone"],
  z_spread_p: ["spread p", true, "chi-square of all z"],
  z_mean: ["z of the mean", null, "the whole picture's mean, worst channel"],
  z_mean_p: ["mean p", true, "whole-picture means"],
  z_worst_x: ["its block, x", null, ""],
  z_worst_y: ["its block, y", null, ""],
  z_tests: ["blocks × channels", null, "that have noise"],
  z_critical: ["critical |z|", null, "exceeded by chance with the probability of the significance"],
  z_share: ["share above critical", false, "of |z| above the critical value at the significance"],
};
const kHeadline = ["relmse", "hdr_flip", "flip", "ssim", "max_difference", "mean_ratio", "z_p"];

function metric_label(name) { return kMetrics[name] ? kMetrics[name][0] : name.replaceAll("_", " "); }
function metric_about(name) { return kMetrics[name] ? kMetrics[name][2] : ""; }

// Four significant digits, plainly where that is short. null stands for what is not finite.
function number_text(value, digits = 4) {
  if (value === null || value === undefined) return "not finite";
  if (Number.isNaN(value)) return "NaN";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e7) return String(value).replace("-", "−");
  const text = size < 1e-4 || size >= 1e7 ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits)));
  return text.replace("-", "−");
}

function limit_text(limit) { return (limit.at_least ? "≥ " : "≤ ") + number_text(limit.limit); }

const kKinds = {
  reference: ["reference", "held against a reference that was computed by other means"],
  baseline: ["baseline: no truth", "held against an earlier picture of the same technique: it says what changed, not what is right"],
  variant: ["variant", "held against another technique or setting that should give the same picture"],
};

// An element with attributes and children; text goes in as text.
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) if (value !== null && value !== undefined) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

function kind_badge(kind) { return make("span", { class: "badge " + kind, title: kKinds[kind][1] }, kKinds[kind][0]); }
function verdict_mark(entry) {
  if (entry.limits.length === 0 && entry.held) return make("span", { class: "mark" }, "not judged");
  return make("span", { class: "mark " + (entry.held ? "held" : "failed") }, entry.held ? "✓ held" : "✗ failed");
}
