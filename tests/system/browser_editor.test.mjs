// An expression made in a browser: needles on the face, one is dragged, the work is named, saved and called, on another
// face too. From the mouse on the page through report bytes and four processes to the picture, and to the disk.
import assert from 'node:assert/strict';
import {existsSync, readdirSync, readFileSync} from 'node:fs';
import {after, afterEach, before, test} from 'node:test';

import {middle, openBrowser, openPage, pull, until} from '../hw-sim/browser/harness.mjs';
import {BoxSystem} from './browser_system.mjs';
import {kEyes, kMouth, kStill, kWhole, View} from './browser_view.mjs';

const kFace = [0.36, 0.3, 0.64, 0.8];
const kCaption = [0, 0.5, 0.3, 1];
const kBack = kStill * 3;  // JPEG blurs what lies beside a change.

// Where the needle in the corner of the mouth stands, on the viewer's right, and where it is dragged to.
const kCorner = [0.541, 0.671];
const kHigher = [0.56, 0.60];

let box;
let browser;
let page;
let view;
let shut;    // The picture before all this.
let opened;  // With needles, nothing pulled.
let pulled;  // And with one pulled.

before(async () => {
  box = new BoxSystem();
  browser = await openBrowser();
  page = await openPage(browser, await box.address());
  view = new View(page);
  await until('every device heard', async () => Object.values((await box.state()).ports).every((p) => p.connected));
  await pull(page, page.getByRole('slider', {name: /^Dial \d: Life$/}), 0, 200);
  await page.mouse.up();
  shut = await view.atRest();
});

after(async () => {
  await browser?.close();
  await box?.close();
});

afterEach((test) => {
  if (test.passed === false) console.log(box.logs());
});

const needles = () => page.getByRole('button', {name: 'Needles', exact: true});
const tool = (name) => page.getByRole('button', {name: new RegExp(`^${name}\\b`)});
const button = (name) => page.getByRole('button', {name: new RegExp(`^Button \\d+: ${name}$`)});

async function at([x, y]) {
  const {x: middle_x, y: middle_y, width, height} = await middle(page.locator('#picture'));
  return [middle_x + (x - 0.5) * width, middle_y + (y - 0.5) * height];
}

async function type(name) {
  for (const letter of name) {
    await page.keyboard.down(letter);
    await new Promise((done) => setTimeout(done, 120));  // Longer than a frame of a machine without a GPU.
    await page.keyboard.up(letter);
    await new Promise((done) => setTimeout(done, 60));
  }
}

test('the switch opens the needles on the face, and says how to use them', async () => {
  await needles().click();
  await until('open', async () => (await box.state()).editor_open);
  await view.untilMoved('a plate with words', shut, kCaption, 8);
  opened = await view.atRest();
  assert.ok(await view.difference(shut, opened, kFace) > 1, 'needles');
});

test('a needle that the mouse drags takes the mouth along, on both sides', async () => {
  await page.mouse.move(...await at(kCorner));
  await page.mouse.down();
  await new Promise((done) => setTimeout(done, 300));
  await page.mouse.move(...await at(kHigher), {steps: 10});
  await page.mouse.up();
  await view.untilMoved('another mouth', opened, kMouth);
  pulled = await view.atRest();
  const [left, top, right, bottom] = kMouth;
  for (const half of [[left, top, 0.5, bottom], [0.5, top, right, bottom]])
    assert.ok(await view.difference(opened, pulled, half) > 2, 'mirrored');
  assert.ok(await view.difference(opened, pulled, kEyes) < await view.difference(opened, pulled, kMouth) / 3);
});

test('undo takes it back, redo brings it again, and Compare shows both', async () => {
  await tool('Undo').click();
  await view.untilBack('the mouth from before', opened, kMouth, 2);
  await tool('Redo').click();
  await view.untilBack('the pulled mouth', pulled, kMouth, kBack);
  await page.mouse.move(...Object.values(await middle(tool('Compare'))).slice(0, 2));
  await page.mouse.down();
  await view.untilMoved('the mouth from before', pulled, kMouth, 2);
  await page.mouse.up();
  await view.untilBack('the pulled mouth again', pulled, kMouth, kBack);
});

test('it is named, saved as readable text, and the needles are shut', async () => {
  await tool('Save').click();
  await view.untilMoved('the question for a name', pulled, kCaption, 2);
  await type('grin');
  await page.keyboard.press('Enter', {delay: 120});
  const own = box.file('kaori/own');
  const text = () => (existsSync(own) ? readdirSync(own) : []).filter((file) => file.endsWith('.toml'))
      .map((file) => readFileSync(`${own}/${file}`, 'utf8')).join();
  await until('a file that holds it', () => text().includes('grin'));
  assert.match(text(), /\[expression\.both\]\n\w+ = \[/, 'a pull of both sides');
  await needles().click();
  await until('shut', async () => !(await box.state()).editor_open);
  await view.untilBack('no plate', shut, kCaption, 2);
});

test('it is called on Kaori, and on another face, by Shift and a digit', async () => {
  await button('Neutral').click();
  await view.untilBack('the mouth as it was', shut, kMouth, kBack);
  await page.keyboard.down('Shift');
  await page.keyboard.press('1', {delay: 200});
  await page.keyboard.up('Shift');
  await view.untilMoved('the grin', shut, kMouth, 1.5);
  const grinning = await view.atRest();
  await button('Round').click();
  await view.untilMoved('another face', grinning, kWhole, 2);
  const round = await view.atRest();
  await button('Neutral').click();
  await view.untilMoved('a round face that does not grin', round, kMouth, 1);
});

test('no script of the page failed', () => assert.deepEqual(page.faults, []));
