/* Asks `umbra serve`, which brought this page, for what the lines do not reach. */

/**
 * @param {string} token of the page
 * @returns {(values: Object<string, number>) => Promise<{curves: {name: string, data: number[]}[]}>}
 *   a call ends the one before it, which then throws AbortError
 */
export function createServer(token) {
  let running = null;
  return async (values) => {
    running?.abort();
    running = new AbortController();
    const answer = await fetch("/compute", {
      method: "POST",
      headers: { "Content-Type": "application/json", Authorization: `Bearer ${token}` },
      body: JSON.stringify({ values }),
      signal: running.signal,
      credentials: "omit",
    });
    const text = await answer.text();
    if (!answer.ok) throw new Error(text.slice(0, 500) || `the program answered ${answer.status}`);
    const result = JSON.parse(text);
    if (!Array.isArray(result.curves)) throw new Error("the program's answer has no curves");
    return result;
  };
}
