import './base.css';
import './views.css';
import './panel.css';
import './tables.css';
import './editors.css';
import './order.css';
import '../panels/lists.css';
import '../small.css';
