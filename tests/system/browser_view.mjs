// The live picture of a page, looked at: how much two pictures differ, and whether the face has come to rest.
import {until} from '../hw-sim/browser/harness.mjs';

// Parts of the picture: left, top, right, bottom.
export const kWhole = [0, 0, 1, 1];
export const kEyes = [0.36, 0.4, 0.64, 0.58];
export const kMouth = [0.42, 0.6, 0.58, 0.76];
const kColumns = 160, kRows = 90;  // Pictures are compared this small.

// Mean differences of 8-bit colours.
export const kStill = 0.4;   // Two pictures of one pose.
export const kMoved = 3;     // Another pose, in the part that moves.
export const kOther = 6;     // Another face, in the whole picture.

export class View {
  constructor(page) {
    this.page = page;
  }

  // The live picture, small; it stays in the page, for `difference`.
  look() {
    return this.page.evaluateHandle(([width, height]) => {
      const canvas = Object.assign(document.createElement('canvas'), {width, height});
      const pen = canvas.getContext('2d', {willReadFrequently: true});
      pen.drawImage(document.querySelector('#picture'), 0, 0, width, height);
      return pen.getImageData(0, 0, width, height).data;
    }, [kColumns, kRows]);
  }

  // How much a part of two pictures differs.
  difference(a, b, part = kWhole) {
    return this.page.evaluate(([one, other, [left, top, right, bottom], width, height]) => {
      let sum = 0, count = 0;
      for (let y = Math.floor(top * height); y < bottom * height; ++y) {
        for (let x = Math.floor(left * width); x < right * width; ++x) {
          const at = (y * width + x) * 4;
          for (let c = 0; c < 3; ++c, ++count) sum += Math.abs(one[at + c] - other[at + c]);
        }
      }
      return sum / count;
    }, [a, b, part, kColumns, kRows]);
  }

  // The picture when the face has come to rest: so many frames on end are the same.
  async atRest() {
    const kFrames = 5;
    let last = await this.look();
    let same = 0;
    await until('a still picture', async () => {
      await new Promise((done) => setTimeout(done, 60));
      const now = await this.look();
      same = await this.difference(last, now) < kStill ? same + 1 : 0;
      last = now;
      return same >= kFrames;
    });
    return last;
  }

  untilMoved(what, from, part, most = kMoved) {
    return until(what, async () => await this.difference(from, await this.look(), part) > most);
  }

  untilBack(what, from, part, least = kStill * 2) {
    return until(what, async () => await this.difference(from, await this.look(), part) < least);
  }
}
