// What a technician and whoever calls the show have on the page besides the cue list, with the real programs: the lines for
// BACK and PANIC, the takes, the operators' monitor, and what a MIDI surface sends.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {closeSync, constants, existsSync, mkdirSync, mkdtempSync, openSync, rmSync, symlinkSync, writeFileSync, writeSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, afterEach, before, test} from 'node:test';

import {openBrowser, openPage, until} from '../hw-sim/browser/harness.mjs';
import {BoxSystem} from './browser_system.mjs';

let box;
let browser;
let page;
let midi;

// Plays beside the dial box, since it has a file: 32 notes and eight controls. Without lamps, which would come back.
const kSurface = `name = "test surface"
usb = ["fffe:0001"]
[midi]
[[midi.dial]]
channel = 1
control = 0
count = 8
mode = "absolute"
[[midi.button]]
channel = 1
note = 0
count = 32
`;

// Folders like the kernel's, with one surface: its node is a pipe.
function makeMidi() {
  midi = mkdtempSync(join(tmpdir(), 'kaori-midi-'));
  const usb = join(midi, 'devices/usb1/1-4');
  const sound = join(usb, '1-4:1.0/sound/card1/midiC1D0');
  for (const folder of [sound, join(midi, 'class'), join(midi, 'snd'), join(midi, 'surfaces')]) mkdirSync(folder, {recursive: true});
  writeFileSync(join(usb, 'idVendor'), 'fffe\n');
  writeFileSync(join(usb, 'idProduct'), '0001\n');
  symlinkSync(sound, join(midi, 'class/midiC1D0'));
  writeFileSync(join(midi, 'surfaces/test.toml'), kSurface);
  execFileSync('mkfifo', [join(midi, 'snd/midiC1D0')]);
}

// What the box's own roles have buttons call: notes 8 to 11 push the buttons 9 to 12.
function makeRoles() {
  const own = join(midi, 'own');
  mkdirSync(own);
  const calls = ['cue go', 'cue back', 'cue panic', 'cue blackout'];
  writeFileSync(join(own, 'roles.toml'), calls.map((call, n) => `[[button]]\nnumber = ${9 + n}\ncall = "${call}"\n`).join('\n'));
  return own;
}

// Fails where nobody has the node open, and does not wait for it.
function send(...bytes) {
  const node = openSync(join(midi, 'snd/midiC1D0'), constants.O_WRONLY | constants.O_NONBLOCK);
  writeSync(node, Buffer.from(bytes));
  closeSync(node);
}

before(async () => {
  makeMidi();
  box = new BoxSystem({options: {'kaori-input': ['--surfaces', join(midi, 'surfaces'), '--midi', midi],
                                 'kaori-stage': ['--own', makeRoles()]}});
  browser = await openBrowser();
  page = await openPage(browser, await box.address());
  await until('every device heard', async () => Object.values((await box.state()).ports).every((p) => p.connected));
});

after(async () => {
  await browser?.close();
  await box?.close();
  if (midi) rmSync(midi, {recursive: true, force: true});
});

afterEach((test) => {
  if (test.passed === false) console.log(box.logs());
});

const now = async () => (await box.state()).on_stage;

test('the lines for BACK and PANIC play the cue list as its keys do', async () => {
  const push = (name) => page.locator('#lines').getByRole('button', {name: new RegExp(`^${name}`)}).click({delay: 150});
  await push('GO');
  await until('a cue', async () => (await now()).cue >= 0);
  await push('Panic');
  await until('the words', async () => (await page.locator('#cues .doing').textContent()).includes('Panic'));
  await page.locator('#cues').getByRole('button', {name: 'Go to cue 20', exact: true}).click();
  const before = await until('cue 20', async () => {
    const {cue} = await now();
    return cue > 5 && cue;
  });
  await push('Back');
  await push('Back');  // The first one may have held what ran.
  await until('an earlier cue', async () => (await now()).cue < before);
});

test('a motion is begun and ended from the page, which says since when it plays', async () => {
  const row = page.locator('#takes li').filter({hasText: 'Look around'});
  assert.match(await row.locator('.about').textContent(), /motion/);
  const length = await row.locator('.length').textContent();
  assert.match(length, /^[1-9]\d*\.\d s$/);
  await row.getByRole('button', {name: 'Start Look around'}).click();
  await until('it plays', async () => (await row.getAttribute('class') ?? '').includes('playing'));
  await until('its time goes', async () => Number.parseFloat(await row.locator('.length').textContent()) > 0.2);
  await row.getByRole('button', {name: 'Stop Look around'}).click();
  await until('it has ended', async () => !(await row.getAttribute('class') ?? '').includes('playing'));
  assert.equal(await row.locator('.length').textContent(), length);
});

test('the operators\u2019 monitor is on the page when somebody wants it, and goes on', async () => {
  const panel = page.locator('#monitor');
  const picture = panel.locator('img');
  assert.equal(await picture.isVisible(), false);
  assert.equal(existsSync(box.file('links/monitor.picture')), false, 'nobody looks: the stage draws none');
  await panel.getByRole('button', {name: 'Show'}).click();
  // Its colours, and a checksum of what stands at the top: the time of day, which goes on each second.
  const look = () => picture.evaluate((img) => {
    if (img.naturalWidth === 0) return null;
    const canvas = Object.assign(document.createElement('canvas'), {width: img.naturalWidth, height: img.naturalHeight});
    const pen = canvas.getContext('2d');
    pen.drawImage(img, 0, 0);
    const {data} = pen.getImageData(0, 0, canvas.width, canvas.height);
    const colours = new Set();
    let clock = 0;
    for (let at = 0; at < data.length; at += 4) {
      colours.add((data[at] >> 4 << 8) | (data[at + 1] >> 4 << 4) | data[at + 2] >> 4);
      if (at < canvas.width * 4 * 60) clock = (clock * 31 + data[at]) % 1000003;
    }
    return {width: canvas.width, colours: colours.size, clock};
  });
  const first = await until('the monitor, with the face in it', async () => {
    const seen = await look();
    return seen && seen.width === 1280 && seen.colours > 100 && seen;
  });
  await until('its clock goes', async () => (await look()).clock !== first.clock);
  if (process.env.KAORI_PICTURES) await new Promise((done) => setTimeout(done, 20000));  // Until all cells are drawn.
  if (process.env.KAORI_PICTURES) await panel.screenshot({path: join(process.env.KAORI_PICTURES, 'controls-monitor.png')});
  await panel.getByRole('button', {name: 'Hide'}).click();
  await until('it is drawn no more', () => !existsSync(box.file('links/monitor.picture')));
});

test('each message of a MIDI surface is on the page in words, with what it is for', async () => {
  const rows = page.locator('#midi li');
  assert.match(await page.locator('#midi').textContent(), /No MIDI surface has sent anything yet/);
  await until('the surface', () => box.logs().includes('test surface is plugged in'));
  send(0xB0, 2, 64, 0x90, 4, 100, 0x80, 4, 0, 0xC0, 9);
  await until('its words', async () => await rows.count() > 3);
  const texts = (await rows.allTextContents()).slice(0, 4);
  assert.match(texts[0], /^fffe:0001program 9.*unknown/);
  assert.match(texts[1], /note 4 off.*button 5/);
  assert.match(texts[2], /note 4 on, velocity 100.*button 5: \w/);
  assert.match(texts[3], /CC 2 = 64.*dial 3: Strength/);
  assert.equal(await rows.first().getAttribute('class'), 'unknown');
  if (process.env.KAORI_PICTURES)
    for (const id of ['takes', 'midi', 'lines']) await page.locator(`#${id}`).screenshot({path: join(process.env.KAORI_PICTURES, `controls-${id}.png`)});
});

test('notes of a MIDI surface play GO, BACK, PANIC and BLACKOUT', async () => {
  const strike = (note) => send(0x90, note, 100, 0x80, note, 0);
  const {cue} = await now();
  strike(8);
  await until('GO', async () => (await now()).cue > cue);
  strike(10);
  await until('PANIC', async () => (await page.locator('#cues .doing').textContent()).includes('Panic'));
  const after = (await now()).cue;
  strike(9);
  await new Promise((done) => setTimeout(done, 300));
  strike(9);  // The first one may have held what ran.
  await until('BACK', async () => (await now()).cue < after);
  strike(11);
  await until('BLACKOUT', async () => (await now()).black);
  strike(11);
  await until('light', async () => !(await now()).black);
});
