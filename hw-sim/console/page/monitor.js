// The operators' monitor, as it stands on a screen of its own behind the stage. The stage draws it only while a page
// shows it.
import {make} from './drag.js';

export function makeMonitor(parent) {
  const button = make('button', {type: 'button', 'aria-pressed': 'false'}, 'Show');
  const picture = make('img', {alt: 'The operators\u2019 monitor', hidden: ''});
  parent.append(make('div', {class: 'calls'}, button), picture);
  let shown = false;
  const follow = () => {
    const wanted = shown && !document.hidden;  // A hidden page costs the show nothing.
    picture.hidden = !shown;
    if (!wanted) picture.removeAttribute('src');
    else if (!picture.hasAttribute('src')) picture.src = `/monitor?${Date.now()}`;
    button.textContent = shown ? 'Hide' : 'Show';
    button.setAttribute('aria-pressed', String(shown));
  };
  button.addEventListener('mousedown', (event) => event.preventDefault());  // The focus stays where it was.
  button.addEventListener('click', () => {
    shown = !shown;
    follow();
  });
  picture.addEventListener('error', () => {
    picture.removeAttribute('src');
    setTimeout(follow, 1000);  // The simulator is away, or has started again.
  });
  document.addEventListener('visibilitychange', follow);
}
