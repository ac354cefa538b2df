// The extension in VS Code's own workbench, which code-server serves, as a browser shows it: opens a
// program, views it, breaks it; prints JSON of what is to be seen.
//
//     node workbench.mjs PLAYWRIGHT_CORE BROWSER ADDRESS PROGRAM
//
// The folder of PROGRAM is what the workbench has open.
import path from "node:path";
import { pathToFileURL } from "node:url";

const [library, executablePath, address, program] = process.argv.slice(2);
const { chromium } = (await import(pathToFileURL(path.join(library, "index.js")))).default;
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu"] });
const page = await (await browser.newContext()).newPage();
page.setDefaultTimeout(240_000);

await page.goto(`${address}/?folder=${encodeURIComponent(path.dirname(program))}`);
const name = path.basename(program);
await page.locator(".explorer-folders-view .monaco-list-row", { hasText: name }).dblclick();
const remark = page.locator(".view-lines span", { hasText: /words\sa\sframe/ }).last();
const seen = { remark: await remark.innerText() };
seen.language = await page.locator(".statusbar-item", { hasText: "Shutter program" }).innerText();

await page.keyboard.press("F1");
await page.keyboard.type("nscc: View shutters");
await page.locator(".quick-input-list .monaco-list-row", { hasText: "View shutters" }).click();
await page.waitForSelector("iframe.webview.ready");
seen.tabs = await page.locator(".tabs-container .tab").allInnerTexts();

await page.locator(".view-lines").first().click();
await page.keyboard.press("Control+End");
await page.keyboard.type("\nopen when n < 3");
await page.waitForSelector(".squiggly-error");
await page.keyboard.press("Control+Shift+M");
const problem = page.locator(".markers-panel .marker-message-line");
await problem.first().waitFor();
seen.problems = await problem.allInnerTexts();
console.log(JSON.stringify(seen));
await browser.close();
