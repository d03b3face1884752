// The console's page in a real browser: hands on the page become report bytes, and what the show draws comes back.
import assert from 'node:assert/strict';
import {request} from 'node:http';
import {after, before, test} from 'node:test';

import {Bench, middle, openBrowser, openPage, pixels, pull, until} from './bench.mjs';

const kUpright = [60, 225, 4, 30];    // Where the toy stage draws the hand of dial 1 at rest,
const kQuarter = [65, 268, 30, 4];    // and after a quarter of a turn clockwise.

let bench;
let browser;
let page;

before(async () => {
  bench = new Bench();
  browser = await openBrowser();
  page = await openPage(browser, await bench.address());
});

after(async () => {
  await browser?.close();
  await bench?.close();
});

const knob = (number) => page.locator('.knob').nth(number - 1);

// The toy stage's clock hands are yellow; its backdrop never is.
async function isYellow(rectangle) {
  const rgba = await pixels(page, rectangle);
  let yellow = 0;
  for (let at = 0; at < rgba.length; at += 4) yellow += rgba[at] > 170 && rgba[at + 1] > 170 && rgba[at + 2] < 150;
  return yellow > rgba.length / 4 / 3;
}

async function drag(locator, dx, dy) {
  await pull(page, locator, dx, dy);
  await page.mouse.up();
}

test('a dial that the mouse turns turns on the box, in the drivers and in the picture', async () => {
  await until('the hand of dial 1 upright', () => isYellow(kUpright));
  await drag(knob(1), 0, -45);  // A quarter of 180 pixels.
  await until('a quarter of 256 counts', () => bench.heard('dial 1')?.[0] === 64);
  assert.equal((await bench.state()).dials[0], 0.25);
  await until('the hand to the right', () => isYellow(kQuarter));
  assert.equal(await isYellow(kUpright), false);
  assert.equal(await knob(1).getAttribute('aria-valuetext'), '0.25 turns');
});

test('a dial goes round with its rim', async () => {
  const {x, y, width} = await middle(knob(2));
  const radius = width * 0.46;
  const at = (turns) => [x + Math.sin(turns * 2 * Math.PI) * radius, y - Math.cos(turns * 2 * Math.PI) * radius];
  await page.mouse.move(...at(0));
  await page.mouse.down();
  for (let step = 1; step <= 24; ++step) await page.mouse.move(...at(step / 16));
  await page.mouse.up();
  await until('one and a half turns clockwise', () => Math.abs(bench.heard('dial 2')?.[0] - 384) <= 4);
});

test('a dial turns by wheel and by arrow keys', async () => {
  const {x, y} = await middle(knob(3));
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -300);
  await until('an eighth of a turn by wheel', () => bench.heard('dial 3')?.[0] === 32);
  await knob(4).focus();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowDown');
  await until('one step by keys', () => bench.heard('dial 4')?.[0] === 8);
  assert.equal(bench.heard('key 82'), undefined, 'the arrows are the dial\'s while it has the focus');
  await knob(4).blur();
});

test('a button lights the lamp that the show says', async () => {
  const button = page.getByRole('button', {name: 'Button 1: Kaori'});
  assert.equal(await button.getAttribute('aria-pressed'), 'false');
  await button.click();
  await until('button 1 down and up', () => bench.lines.includes('button 1 1') && bench.lines.includes('button 1 0'));
  await until('its lamp', async () => await button.getAttribute('aria-pressed') === 'true');
  await button.click();
  await until('its lamp out', async () => await button.getAttribute('aria-pressed') === 'false');
});

test('the space bar blinks, also after a click, and the picture shows it', async () => {
  await page.getByRole('button', {name: 'Button 2: Dog'}).click();
  await page.keyboard.down('Space');
  await until('key 44 down', () => bench.heard('key 44')?.[0] === 1);
  await until('a dark picture', async () => Math.max(...(await pixels(page, [10, 10, 4, 4])).filter((_, n) => n % 4 < 3)) < 20);
  await page.keyboard.up('Space');
  await until('key 44 up', () => bench.heard('key 44')?.[0] === 0);
  assert.equal(bench.lines.filter((line) => line === 'button 2 1').length, 1, 'Space did not push the button');
});

test('keys that are held when the page loses the keyboard are let go', async () => {
  await page.keyboard.down('KeyQ');
  await until('key 20 down', () => bench.heard('key 20')?.[0] === 1);
  await page.evaluate(() => window.dispatchEvent(new Event('blur')));
  await until('key 20 up', () => bench.heard('key 20')?.[0] === 0);
  await page.keyboard.up('KeyQ');
});

test('a cap on the page presses its key while it is held', async () => {
  const {x, y} = await middle(page.getByRole('button', {name: 'Nod: key 1'}));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await until('key 30 down', () => bench.heard('key 30')?.[0] === 1);
  await page.mouse.up();
  await until('key 30 up', () => bench.heard('key 30')?.[0] === 0);
});

test('the lip pad opens the lips before the camera, and they spring shut', async () => {
  const pad = page.locator('.lips');
  const {x, y, height} = await middle(pad);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y + height * 0.45, {steps: 4});
  await until('an open mouth', async () => (await bench.state()).lips.height > 1);
  await page.mouse.up();
  await until('a shut mouth', async () => (await bench.state()).lips.height === 0.25);
});

test('a cable that is pulled takes the device away, and back', async () => {
  await page.getByRole('button', {name: 'Unplug the dial box'}).click();
  await until('an unplugged box', async () => (await bench.state()).ports['dial-box'].plugged === false);
  await page.getByRole('button', {name: 'Plug in the dial box'}).click();
  await until('a box that is heard', async () => (await bench.state()).ports['dial-box'].connected);
  const before = bench.heard('dial 1')[0];
  await drag(knob(1), 0, 45);
  await until('a quarter back', () => bench.heard('dial 1')[0] === before - 64);
});

test('two fingers move two sticks at once, and both spring back', async () => {
  const phone = {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true};
  const touched = await openPage(browser, await bench.address(), phone);
  await touched.locator('#left').scrollIntoViewIfNeeded();
  const left = await middle(touched.locator('#left .pad'));
  const right = await middle(touched.locator('#right .pad'));
  const fingers = await touched.context().newCDPSession(touched);
  const touch = (type, points) => fingers.send('Input.dispatchTouchEvent', {type, touchPoints: points});
  const at = (pad, id, dx, dy) => ({id, x: pad.x + dx * pad.width / 2, y: pad.y + dy * pad.width / 2});
  await touch('touchStart', [at(left, 0, 0, 0), at(right, 1, 0, 0)]);
  await touch('touchMove', [at(left, 0, 0.8, 0), at(right, 1, 0, 0.8)]);
  await until('left stick to the right', () => bench.heard('stick-left')?.[0] > 0.7);
  await until('right stick pulled back', () => bench.heard('stick-right')?.[1] < -0.7);
  await touch('touchEnd', []);
  await until('both in the middle', () => bench.heard('stick-left')[0] === 0 && bench.heard('stick-right')[1] === 0);
  await touched.context().close();
});

test('a slider stays where it is put', async () => {
  await page.getByRole('slider', {name: 'Head: slider'}).fill('0.5');
  await until('half way', () => bench.heard('stick-left')?.[3] === 0.5);
});

test('a page that is closed in the middle of a drag lets go', async () => {
  await page.goto('about:blank');  // The only page that listens shall be the one that is closed.
  const leaving = await openPage(browser, await bench.address());
  const {x, y, width} = await middle(leaving.locator('#left .pad'));
  await leaving.mouse.move(x, y);
  await leaving.mouse.down();
  await leaving.mouse.move(x + width * 0.4, y, {steps: 4});
  await until('a stick to the right', () => bench.heard('stick-left')[0] > 0.7);
  await leaving.context().close();
  await until('the stick in the middle', () => bench.heard('stick-left')[0] === 0);
  await page.goto(await bench.address());
});

test('several pages see the same box', async () => {
  const second = await openPage(browser, await bench.address());
  await drag(knob(5), 0, -90);
  await until('the dial on the other page', async () =>
      await second.locator('.knob').nth(4).getAttribute('aria-valuetext') === '0.50 turns');
  await second.context().close();
});

test('the page fits a phone and a desk without a sideways scroll', async () => {
  for (const [width, height] of [[360, 740], [390, 844], [820, 1180], [1280, 720], [1440, 900], [2560, 1440]]) {
    await page.setViewportSize({width, height});
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= width, `${wide} px are needed at ${width}x${height}`);
  }
  await page.setViewportSize({width: 1440, height: 900});
});

test('the picture comes at 15 frames/s at least, at 960x540', async () => {
  const kSeconds = 3;
  const stop = new AbortController();
  const stream = await fetch(new URL('picture', await bench.address()), {signal: stop.signal});
  let frames = 0;
  const start = performance.now();
  for await (const part of stream.body) {
    frames += Buffer.from(part).toString('latin1').split('Content-Type: image/jpeg').length - 1;
    if (performance.now() - start > kSeconds * 1000) break;
  }
  stop.abort();
  console.log(`${(frames / kSeconds).toFixed(1)} frames/s beside the page's own`);
  assert.ok(frames >= 15 * kSeconds, `${frames} frames in ${kSeconds} s`);
});

// A request with headers that a browser would not let a page set.
async function status(headers, method = 'POST', body = 'dial 8 turn 1') {
  const url = new URL('hands', await bench.address());
  return new Promise((done, fail) => {
    request(url, {method, headers}, (reply) => reply.resume().on('end', () => done(reply.statusCode)))
        .on('error', fail).end(body);
  });
}

test('only the page itself may play', async () => {
  const {origin, host} = new URL(await bench.address());
  assert.equal(await status({Host: 'kaori.example'}), 403);
  assert.equal(await status({Host: host, Origin: 'http://kaori.example'}), 403);
  assert.equal(await status({Host: host, 'Sec-Fetch-Site': 'cross-site'}), 403);
  assert.equal((await bench.state()).dials[7], 0);
  assert.equal(await status({Host: host, Origin: origin}), 204);
  assert.equal((await bench.state()).dials[7], 1);
});

test('a bad hand is refused in one clear line, and a long one unread', async () => {
  const reply = await fetch(new URL('hands', await bench.address()), {method: 'POST', body: 'dial 9 turn 1'});
  assert.equal(reply.status, 400);
  assert.equal(await reply.text(), '1:6: no dial 9; dials are 1 to 8\n');
  const {host} = new URL(await bench.address());
  assert.equal(await status({Host: host}, 'POST', 'dial 1 turn 0\n'.repeat(1000)), 413);
  assert.equal(await status({Host: host}, 'DELETE', ''), 405);
});

test('nothing was asked of another machine, and no script failed', async () => {
  const {origin} = new URL(await bench.address());
  assert.deepEqual(page.asked.filter((url) => !url.startsWith(origin)), []);
  assert.deepEqual(page.faults, []);
});

test('the page waits for a simulator that has stopped', async () => {
  bench.process.kill('SIGTERM');
  await until('the word that it stopped', () => page.evaluate(() => document.body.dataset.link === 'lost'));
});
