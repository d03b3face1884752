// Arrow keys on a control that has the focus: a direction while they are held, several at once add up.

// Right and up are positive, as in positionIn.
const kDirections = new Map([
  ['ArrowLeft', [-1, 0]], ['ArrowRight', [1, 0]], ['ArrowUp', [0, 1]], ['ArrowDown', [0, -1]],
]);

// Calls lean([x, y]), each -1, 0 or 1, when the held keys change, and lean(null) when none is held any more: also when
// the focus leaves in the middle of it, since the keys would be let go elsewhere.
export function onArrows(element, lean) {
  const held = new Set();
  const tell = () => {
    if (held.size === 0) return lean(null);
    const sum = [...held].map((code) => kDirections.get(code)).reduce((a, b) => [a[0] + b[0], a[1] + b[1]]);
    return lean(sum);
  };
  element.addEventListener('keydown', (event) => {
    if (!kDirections.has(event.code)) return;
    event.preventDefault();
    held.add(event.code);
    if (!event.repeat) tell();
  });
  element.addEventListener('keyup', (event) => {
    if (held.delete(event.code)) tell();
  });
  element.addEventListener('blur', () => {
    if (held.size === 0) return;
    held.clear();
    tell();
  });
}
