// Shows the points that the labs' pages keep in this browser, and where to go on. Without this script all labs are there.
{
  const folder = location.pathname.replace(/[^/]*$/, "");
  const kept = card => { try { return JSON.parse(localStorage.getItem(`relief ${folder}${card.dataset.live} points`)); } catch { return null; } };
  const labs = [...document.querySelectorAll("article[data-live]")].map(card => ({card, mine: kept(card)}));
  const is_done = ({mine}) => Boolean(mine) && mine.points >= mine.of;
  const text = points => String(Math.round(points * 100) / 100);
  const begun = labs.filter(({mine}) => mine);
  for (const {card, mine} of begun) {
    const line = card.querySelector(".points"), bar = document.createElement("progress");
    bar.max = mine.of, bar.value = mine.points;
    bar.setAttribute("aria-label", "your points");
    line.append(document.createElement("br"), bar, ` you have ${text(mine.points)}${mine.optional ? " + " + text(mine.optional) : ""} of ${mine.of}`);
  }
  if (begun.length) {
    // The lab of the last checks if points are missing there, else the next one that is no elective.
    const last = begun.reduce((a, b) => a.mine.at > b.mine.at ? a : b), later = labs.slice(labs.indexOf(last) + 1);
    const open = lab => !is_done(lab) && !lab.card.dataset.elective;
    const next = is_done(last) ? later.find(open) ?? labs.find(lab => !is_done(lab)) : last;
    const link = document.querySelector("a.begin");
    if (next && link) {
      link.href = next.card.dataset.live;
      link.textContent = "Continue with lab " + next.card.querySelector("h3").textContent;
    }
    const sum = document.createElement("li"), number = document.createElement("b");
    number.textContent = text(begun.reduce((points, {mine}) => points + mine.points + mine.optional, 0));
    sum.append(number, "of them yours");
    document.querySelector(".sum").append(sum);
  }
}
