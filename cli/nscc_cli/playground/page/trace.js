// The words of one pixel, step by step, with its registers.

export function showTrace($, { registers, steps, words, exposure_e: exposure }, row) {
  $("step").max = Math.max(0, steps.length - 1);
  $("step").value = 0;
  $("listing").replaceChildren(...steps.map(({ word }, k) => {
    const item = document.createElement("li");
    item.textContent = word;
    item.onclick = () => go(k);
    return item;
  }));
  const missing = words > steps.length ? ` The first ${steps.length} of ${words} words are listed.` : "";
  const read = Object.entries(exposure).map(([name, electrons]) => `${name}: ${electrons.toFixed(1)} electrons`);
  $("exposed").textContent = `Read out: ${read.join(", ")}.${missing}`;

  function go(k) {
    $("step").value = k;
    const [now, before] = [steps[k], steps[k - 1]];
    $("now").textContent = `${k + 1} of ${steps.length}: ${now.word}, ${now.us.toLocaleString()} us, boundary ${now.boundary}`;
    const values = row("td", now.values.map((value) => value.toLocaleString()));
    now.values.forEach((value, at) => {
      values.cells[at].className = before && value !== before.values[at] ? "new" : "";
    });
    $("registers").replaceChildren(row("th", registers), values);
    for (const item of $("listing").children) item.removeAttribute("aria-current");
    const item = $("listing").children[k];
    item.setAttribute("aria-current", "step");
    $("listing").scrollTop = item.offsetTop - $("listing").offsetTop - 60;
  }

  $("step").oninput = ({ target }) => go(Number(target.value));
  if (steps.length) go(0);
}
