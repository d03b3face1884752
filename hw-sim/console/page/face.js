// The picture as a handle: the face turns and looks to where it is dragged. Both sticks move, as one operator with one
// stick on each side would move them.
import {clamp, positionIn, springBack} from './drag.js';
import {set} from './wire.js';

const kHead = 0.85;  // Of a stick's way, at the edge of the picture;
const kGaze = 0.6;   // the eyes go the rest of the way in the head.
const kRest = [0, 0];

const line = (side, [x, y], part) => `${side} move ${(x * part).toFixed(4)} ${(y * part).toFixed(4)}`;

// For onDrag.
export function steering(picture) {
  let value = kRest;
  let stop = () => {};
  const put = (next) => {
    value = next;
    set('left move', line('left', value, kHead));
    set('right move', line('right', value, kGaze));
  };
  const follow = (event) => {
    const {x, y} = positionIn(picture, event);
    stop();
    put([clamp(x * 1.6, -1, 1), clamp(y * 1.3, -1, 1)]);
  };
  return {begin: follow, move: follow, end: () => { stop = springBack(value, kRest, put); }};
}
