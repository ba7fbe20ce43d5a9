/* Time slider and play button over a clock. */
import { button, el } from "./dom.js";
import { nearest } from "./clock.js";
import { utcClock, utcDate } from "./format.js";

const WHOLE_S = 24;
const calm = matchMedia("(prefers-reduced-motion: reduce)");

/**
 * @param {ArrayLike<number>} times ascending, seconds since 1970
 * @param {import("./clock.js").Clock} clock
 * @param {(i: number) => string} remark said behind the instant
 */
export function createPlayer(times, clock, remark) {
  const last = times.length - 1;
  let playing = false;
  let began = 0;
  const slider = el("input", {
    type: "range", class: "time-slider", min: 0, max: last, step: 1, value: 0, "aria-label": "Time",
    on: { input: () => clock.move(times[Number(slider.value)]) },
  });
  const output = el("output", { class: "time-output" });
  const play = button("Play", () => (playing ? stop() : start()), { class: "play", "aria-pressed": "false" });

  function start() {
    playing = true;
    play.textContent = "Pause";
    play.setAttribute("aria-pressed", "true");
    const i = Number(slider.value);
    began = performance.now() - ((i >= last ? 0 : i) / last) * WHOLE_S * 1000;
    requestAnimationFrame(tick);
  }
  function stop() {
    playing = false;
    play.textContent = "Play";
    play.setAttribute("aria-pressed", "false");
  }
  function tick(now) {
    if (!playing) return;
    // Who asked for less motion sees two pictures a second.
    const passed = calm.matches ? Math.floor((now - began) / 500) * 500 : now - began;
    const i = Math.round((passed / (WHOLE_S * 1000)) * last);
    clock.move(times[Math.min(last, i)]);
    if (i >= last) stop();
    else requestAnimationFrame(tick);
  }
  const show = (at) => {
    const i = nearest(times, at);
    if (i < 0) return;
    slider.value = String(i);
    const text = `${utcClock(times[i])} UTC`;
    output.textContent = [text, remark(i)].filter(Boolean).join(" · ");
    slider.setAttribute("aria-valuetext", `${utcDate(times[i])} ${output.textContent}`);
  };
  clock.moved.add(show);
  return { node: el("div", { class: "player" }, play, slider, output), show };
}
