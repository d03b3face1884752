// Fingers and mouse alike: one drag per pointer, any number of pointers at once.

// Calls begin(event), move(event), end() while a pointer holds `element`. Focus stays where it was, so that the
// space bar still blinks after a click.
export function onDrag(element, {begin, move, end}) {
  let pointer = null;
  element.addEventListener('pointerdown', (event) => {
    if (pointer !== null || event.button !== 0) return;
    event.preventDefault();
    pointer = event.pointerId;
    element.setPointerCapture(pointer);
    element.classList.add('held');
    begin?.(event);
  });
  element.addEventListener('mousedown', (event) => event.preventDefault());
  element.addEventListener('contextmenu', (event) => event.preventDefault());
  element.addEventListener('pointermove', (event) => {
    if (event.pointerId === pointer) move?.(event);
  });
  const finish = (event) => {
    if (event.pointerId !== pointer) return;
    pointer = null;
    element.classList.remove('held');
    end?.();
  };
  for (const name of ['pointerup', 'pointercancel', 'lostpointercapture']) element.addEventListener(name, finish);
}

// A button that is held: by pointers, or by Enter and Space when it has the focus.
export function onHold(element, {push, release}) {
  let held = false;
  const set = (down) => {
    if (down === held) return;
    held = down;
    element.classList.toggle('held', down);
    (down ? push : release)();
  };
  onDrag(element, {begin: () => set(true), end: () => set(false)});
  const isPush = (event) => event.code === 'Enter' || event.code === 'Space';
  element.addEventListener('keydown', (event) => {
    if (isPush(event)) set(true);
  });
  element.addEventListener('keyup', (event) => {
    if (isPush(event)) set(false);
  });
  element.addEventListener('blur', () => set(false));
  return () => set(false);
}

// Where the pointer is in the element: -1..1 to the right and upwards.
export function positionIn(element, event) {
  const box = element.getBoundingClientRect();
  return {
    x: ((event.clientX - box.left) / box.width) * 2 - 1,
    y: 1 - ((event.clientY - box.top) / box.height) * 2,
  };
}

export const clamp = (value, least, most) => Math.min(most, Math.max(least, value));

// Lets `value` (an array) spring back to `rest` in about a tenth of a second; show(value) each frame.
export function springBack(value, rest, show) {
  const kPerFrame = 0.42;
  let stopped = false;
  let now = value;
  const step = () => {
    if (stopped) return;
    now = now.map((v, i) => v + (rest[i] - v) * kPerFrame);
    const arrived = now.every((v, i) => Math.abs(v - rest[i]) < 0.01);
    show(arrived ? rest : now);
    if (!arrived) requestAnimationFrame(step);
  };
  step();
  return () => {
    stopped = true;
  };
}

export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}
