/** A Denavit-Hartenberg table with the row and the number of the present step marked. */
import { create, setMarkup } from "./markup.js";

export function createTable({ columns_html, rows, row, cell, variables, convention }) {
  const table = create("table");
  table.createCaption().textContent = `${convention} convention`;
  const head = table.createTHead().insertRow();
  for (const html of ["<i>i</i>", ...columns_html]) {
    head.append(setMarkup(create("th"), html));
  }
  const body = table.createTBody();
  rows.forEach((numbers, i) => {
    const line = body.insertRow();
    line.classList.toggle("present", i === row);
    line.insertCell().textContent = String(i + 1);
    numbers.forEach((text, j) => {
      const td = line.insertCell();
      td.textContent = text.replace("-", "\u2212");
      td.classList.toggle("present", i === row && j === cell);
      td.classList.toggle("variable", variables?.[i] === j);
    });
  });
  return table;
}
