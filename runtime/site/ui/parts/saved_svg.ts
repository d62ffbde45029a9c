// A drawing of the page as an SVG file of its own: what the page's style sheet says of it stands in its attributes, in the
// colours of the light theme, for a paper.

const ATTRIBUTES = [
  'fill',
  'stroke',
  'stroke-width',
  'stroke-dasharray',
  'stroke-linejoin',
  'paint-order',
  'font-size',
  'font-weight',
  'text-anchor',
] as const;

/** `box`: the part of `content` (a group of `drawing`) that is saved, in its own units. */
export function savedSvg(
  drawing: SVGSVGElement,
  content: string,
  box: { readonly x: number; readonly y: number; readonly width: number; readonly height: number; },
): string {
  const host = document.createElement('div');
  host.className = 'saved-drawing';
  const copy = drawing.cloneNode(true);
  if (!(copy instanceof SVGSVGElement)) return '';
  host.append(copy);
  // Beside the original: the same rules reach it.
  drawing.parentElement?.append(host);
  const ground = getComputedStyle(host).backgroundColor;
  for (const element of copy.querySelectorAll<SVGElement>('path, rect, text, tspan')) {
    const style = getComputedStyle(element);
    for (const name of ATTRIBUTES) {
      const value = style.getPropertyValue(name);
      if (value !== '' && value !== 'normal') element.setAttribute(name, value);
    }
  }
  host.remove();
  for (const element of copy.querySelectorAll('*')) {
    for (const { name } of [...element.attributes]) {
      if (name === 'class' || name === 'role' || name === 'tabindex' || name.startsWith('aria-')) element.removeAttribute(name);
    }
  }
  // Characters that XML has no place for.
  for (const element of copy.querySelectorAll('title, text, tspan')) {
    for (const child of element.childNodes) {
      if (child instanceof Text) child.data = child.data.replace(/[\p{Cc}\p{Cs}\ufffe\uffff]/gu, '\ufffd');
    }
  }
  const inside = drawing.querySelector(content);
  const index = inside === null ? -1 : [...drawing.children].indexOf(inside);
  const whole = copy.children[index] ?? copy;
  whole.removeAttribute('transform');
  const saved = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  const back = document.createElementNS('http://www.w3.org/2000/svg', 'rect');
  const numbers = { x: box.x, y: box.y, width: box.width, height: box.height };
  for (const [name, value] of Object.entries(numbers)) back.setAttribute(name, String(Math.round(value)));
  back.setAttribute('fill', ground);
  saved.setAttribute('viewBox', [box.x, box.y, box.width, box.height].map(Math.round).join(' '));
  saved.setAttribute('width', String(Math.round(box.width)));
  saved.setAttribute('height', String(Math.round(box.height)));
  saved.setAttribute('font-family', 'sans-serif');
  saved.append(back, whole);
  return `${new XMLSerializer().serializeToString(saved)}\n`;
}
